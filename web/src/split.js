// Bars between the parts of the page, for mouse and keys.

export function split(bar, axis, change) {
  const drag = (event) => {
    const box = bar.parentElement.getBoundingClientRect();
    set(axis === "x" ? (event.clientX - box.left) / box.width : (event.clientY - box.top) / box.height);
  };
  const set = (share) => {
    const value = Math.max(0.08, Math.min(0.92, share));
    bar.setAttribute("aria-valuenow", Math.round(value * 100));
    change(value);
  };
  bar.addEventListener("pointerdown", (event) => {
    bar.setPointerCapture(event.pointerId);
    bar.addEventListener("pointermove", drag);
    bar.addEventListener("pointerup", () => bar.removeEventListener("pointermove", drag), { once: true });
    event.preventDefault();
  });
  bar.addEventListener("keydown", (event) => {
    const by = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
    if (!by) return;
    event.preventDefault();
    set((Number(bar.getAttribute("aria-valuenow")) + by * 3) / 100);
  });
}
