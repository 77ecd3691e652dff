//! What shows source text, drawings and models.

use crate::text::Span;

use super::line::Line;

/// A line of the preprocessor of C.
pub fn preprocessor(line: &Line<'_>, _: usize) -> Option<Span> {
    let text = line.text.trim_ascii_start();
    let rest = text.strip_prefix(b"#")?.trim_ascii_start();
    let words: [&[u8]; 8] =
        [b"include ", b"include<", b"ifndef ", b"ifdef ", b"define ", b"pragma ", b"undef ", b"if defined"];
    let is_one = words.iter().any(|word| rest.starts_with(word))
        || rest.starts_with(b"include\"")
        || text.trim_ascii_end() == b"#endif";
    is_one.then(|| line.span())
}

/// `typedef struct {`, `extern "C" {`, `namespace a {`, `enum Tool { A };`
pub fn type_declaration(line: &Line<'_>, _: usize) -> Option<Span> {
    const WORDS: [&[u8]; 8] =
        [b"typedef ", b"struct ", b"enum ", b"union ", b"namespace ", b"class ", b"template", b"using namespace "];
    let text = line.text.trim_ascii();
    let begins = WORDS.iter().any(|word| text.starts_with(word));
    let is_code = text.last().is_some_and(|last| b"{;}".contains(last)) || text.starts_with(b"template<");
    let is_linkage = text.starts_with(b"extern \"C");
    (begins && is_code || is_linkage).then(|| line.span())
}

/// `int tool(void);`, `static const double PITCH = 1.5;`
pub fn prototype(line: &Line<'_>, _: usize) -> Option<Span> {
    const BEFORE: [&[u8]; 6] = [b"static", b"extern", b"inline", b"const", b"unsigned", b"signed"];
    const TYPES: [&[u8]; 9] = [b"void", b"int", b"char", b"float", b"double", b"bool", b"long", b"short", b"size_t"];
    let text = line.text.trim_ascii();
    let mut words = text.split(|b| matches!(b, b' ' | b'\t' | b'*')).filter(|word| !word.is_empty());
    let kind = words.find(|word| !BEFORE.contains(word))?;
    let is_type = TYPES.contains(&kind) || kind.ends_with(b"_t") && kind.iter().all(|b| is_of_name(*b));
    let name = words.next()?;
    let letters = name.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
    let behind = if letters < name.len() { &name[letters..] } else { words.next()? };
    let is_declared = behind.first().is_some_and(|b| b"(=[;".contains(b));
    let ends = text.last().is_some_and(|last| b";{,)".contains(last));
    (is_type && letters > 0 && !name[0].is_ascii_digit() && is_declared && ends).then(|| line.span())
}

fn is_of_name(byte: u8) -> bool {
    byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_'
}

/// `// of the tool`
pub fn line_comment(line: &Line<'_>, _: usize) -> Option<Span> {
    line.text.trim_ascii_start().starts_with(b"//").then(|| line.span())
}

/// `/* Tools`
pub fn comment_begins(line: &Line<'_>, _: usize) -> Option<Span> {
    line.text.trim_ascii_start().starts_with(b"/*").then(|| line.span())
}

/// `of the machine */`
pub fn comment_ends(line: &Line<'_>, _: usize) -> Option<Span> {
    line.text.trim_ascii_end().ends_with(b"*/").then(|| line.span())
}

/// The first group of a DXF, a comment in front of it or not.
pub fn dxf_group(line: &Line<'_>, at: usize) -> Option<Span> {
    (at == 0 && matches!(line.text.trim_ascii(), b"0" | b"999")).then(|| line.span())
}

/// Its first section.
pub fn dxf_section(line: &Line<'_>, at: usize) -> Option<Span> {
    (at > 0 && at < 8 && line.text.trim_ascii() == b"SECTION").then(|| line.span())
}

/// `ISO-10303-21;`
pub fn step_head(line: &Line<'_>, at: usize) -> Option<Span> {
    (at == 0 && line.text.trim_ascii().starts_with(b"ISO-10303-21")).then(|| line.span())
}

/// `solid bracket`
pub fn stl_head(line: &Line<'_>, at: usize) -> Option<Span> {
    (at == 0 && line.text.trim_ascii().starts_with(b"solid")).then(|| line.span())
}

/// `facet normal 0 0 1`
pub fn stl_facet(line: &Line<'_>, at: usize) -> Option<Span> {
    (at < 4 && line.text.trim_ascii().starts_with(b"facet normal")).then(|| line.span())
}
