# What `.ci/fuzz` and `fuzz/run` share: they build the targets and lay out their seeds. Sourced in the folder of the project.
#
# Needs a C++ compiler for libFuzzer, no nightly and no cargo-fuzz: the coverage that guides the fuzzer comes from a pass
# of LLVM that stable rustc has.

host="$(rustc -vV | sed -n 's/^host: //p')"

all_targets() { (cd fuzz/fuzz_targets && LC_ALL=C ls | sed 's/\.rs$//'); }

build_targets() {
  local coverage="-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table -Ccodegen-units=16"
  # With a target named, build scripts and macros stay without the pass.
  RUSTFLAGS="$(echo $coverage)" cargo build --locked --quiet --manifest-path fuzz/Cargo.toml --target "$host"
}

# The programs of the golden books of a folder, a file each: what stands between the lines that structure a book, without what
# partc made of it.
seed() {
  find "tests/golden/$1" -name '*.snap' | LC_ALL=C sort | while read -r book; do
    awk -v into="$2/$(echo "${book%.snap}" | tr '/' '_')" '
      /^(=== |== |-- )/ { part++; made = $0 == "-- then"; next }
      made || !part { next }
      /│/ { sub(/ *│.*/, ""); if ($0 == "") next }
      { print > (into "_" part); if (part != last) { close(into "_" last); last = part } }' "$book"
  done
}

# Lays out the seeds of a target in `$seeds`, and names its dictionary.
lay_out() {
  local target="$1"
  seeds="fuzz/target/seeds/$target"
  rm -rf "$seeds"
  mkdir -p "$seeds" "fuzz/artifacts/$target"
  case "$target" in
    *klartext) seed klartext "$seeds" && dictionary=klartext ;;
    *turning) seed heidenhain-turning "$seeds" && dictionary=turning ;;
    gcode) seed gcode "$seeds" && dictionary=gcode ;;
    mtc200) seed mtc200 "$seeds" && dictionary=mtc200 ;;
    sinumerik) seed sinumerik "$seeds" && dictionary=sinumerik ;;
    *) dictionary="$target" ;;
  esac
  # Small programs of its own.
  if [ -d "fuzz/seeds/$target" ]; then cp "fuzz/seeds/$target"/* "$seeds"; fi
  if [ "$target" = tables ]; then
    find tests/golden -name '*.toml' -exec cp {} "$seeds" \;
  fi
}

# Runs a target with its dictionary; the rest are options of libFuzzer.
run_target() {
  local target="$1"
  shift
  "fuzz/target/$host/debug/$target" -timeout=60 -rss_limit_mb=2048 -print_final_stats=1 \
    -dict="fuzz/dictionaries/$dictionary.dict" -artifact_prefix="fuzz/artifacts/$target/" "$@" >"fuzz/target/$target.log" 2>&1
}

# The end of what a target said, where it failed.
say_failed() {
  tail -n 60 "fuzz/target/$1.log"
  echo "$1 failed; the input is in fuzz/artifacts/$1"
}
