// What the page begins with: examples/flange.H.

import text from "../../examples/flange.H";

export const EXAMPLE = text;
