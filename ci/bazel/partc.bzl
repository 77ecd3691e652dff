"""Rules that compile and check part programs with partc.

    load("//ci/bazel:partc.bzl", "partc_check_test", "partc_compile")

A program is compiled again when one of its inputs changes: the program, `deps` (programs that it calls) and `config` (partc.toml, what it
extends, tool and datum tables). What is not named here is not there when partc runs, and a call of it is an error.
"""

# partc takes no called program behind a link that leads out of its folder, and the inputs of an action are such links: they are copied.
# Arguments: partc, program, output, target, inputs …
_COMPILE = """
set -euo pipefail
partc=$(realpath "$1"); program=$2; out=$PWD/$3; target=$4; shift 4
stage=$(mktemp -d); trap 'rm -rf "$stage"' EXIT
for file in "$@"; do
  mkdir -p "$stage/$(dirname "$file")"
  cp -L "$file" "$stage/$file"
done
cd "$stage"
"$partc" compile "$program" --target "$target" -o "$out"
"""

_CHECK = """#!/usr/bin/env bash
set -euo pipefail
partc=$(realpath "{partc}")
stage=$(mktemp -d); trap 'rm -rf "$stage"' EXIT
for file in {files}; do
  mkdir -p "$stage/$(dirname "$file")"
  cp -L "$file" "$stage/$file"
done
cd "$stage"
"$partc" check {programs} --format junit -o "${{XML_OUTPUT_FILE:-/dev/null}}"
"""

_ATTRS = {
    "config": attr.label_list(allow_files = True, doc = "partc.toml, what it extends, tables"),
    "deps": attr.label_list(allow_files = True, doc = "programs that are called"),
    "_partc": attr.label(default = "//:partc", executable = True, cfg = "exec", allow_single_file = True),
}

def _compile_impl(ctx):
    inputs = [ctx.file.src] + ctx.files.deps + ctx.files.config
    ctx.actions.run_shell(
        inputs = inputs,
        outputs = [ctx.outputs.out],
        tools = [ctx.executable._partc],
        command = _COMPILE,
        arguments = [ctx.executable._partc.path, ctx.file.src.path, ctx.outputs.out.path, ctx.attr.target] +
                    [file.path for file in inputs],
        mnemonic = "Partc",
        progress_message = "Compiling %{label}",
    )
    return [DefaultInfo(files = depset([ctx.outputs.out]))]

partc_compile = rule(
    implementation = _compile_impl,
    attrs = dict(
        _ATTRS,
        src = attr.label(allow_single_file = True, mandatory = True),
        out = attr.output(mandatory = True),
        target = attr.string(default = "linuxcnc"),
    ),
)

def _quoted(path):
    return "'" + path.replace("'", "'\\''") + "'"

def _check_impl(ctx):
    files = ctx.files.srcs + ctx.files.deps + ctx.files.config
    script = ctx.actions.declare_file(ctx.label.name + ".sh")
    ctx.actions.write(script, _CHECK.format(
        partc = ctx.executable._partc.short_path,
        files = " ".join([_quoted(file.short_path) for file in files]),
        programs = " ".join([_quoted(file.short_path) for file in ctx.files.srcs]),
    ), is_executable = True)
    return [DefaultInfo(
        executable = script,
        runfiles = ctx.runfiles(files = files + [ctx.executable._partc]),
    )]

partc_check_test = rule(
    implementation = _check_impl,
    test = True,
    attrs = dict(_ATTRS, srcs = attr.label_list(allow_files = True, mandatory = True)),
)
