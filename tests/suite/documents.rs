//! What the documents show of the command line is what it does: blocks of `console`.

#[test]
fn commands_in_the_documents_do_what_they_show() {
    trycmd::TestCases::new()
        .register_bin("partc", std::path::Path::new(env!("CARGO_BIN_EXE_partc")))
        .case("README.md")
        .case("CONTRIBUTING.md")
        .case("docs/*.md");
}
