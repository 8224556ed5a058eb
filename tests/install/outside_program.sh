#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# outside_program.sh BUILD_FOLDER SOURCE_FOLDER
# Installs, moves what was installed, builds programs of others against it, and compares what the examples print with
# what their README shows: each block marked `console` holds commands after "$ " and their output.
set -eu
build=$1 source=$2
work=$build/outside
fail() { echo "$*" >&2; exit 1; }

rm -rf "$work"
mkdir -p "$work"
cmake --install "$build" --prefix "$work/installed" >/dev/null
mv "$work/installed" "$work/moved"
prefix=$work/moved
export prefix

echo "== no path of this machine in the package"
if grep -rF -e "$source" -e "$build" "$prefix/lib/cmake"; then
    fail "these lines name the folder of the sources or of the build"
fi

launcher=
if command -v ccache >/dev/null; then
    launcher=-DCMAKE_CXX_COMPILER_LAUNCHER=ccache
    export CCACHE_BASEDIR="$work" CCACHE_NOHASHDIR=1
fi
build_outside() { # SOURCES NAME
    if ! (cmake -G Ninja -S "$1" -B "$work/$2" -DCMAKE_PREFIX_PATH="$prefix" \
        -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' $launcher && cmake --build "$work/$2") >"$work/$2.log" 2>&1; then
        cat "$work/$2.log"
        fail "$2: does not build"
    fi
}

echo "== components and a plugin"
build_outside "$source/tests/install/components" components

echo "== the examples"
build_outside "$prefix/share/doc/offmap/doc/examples" examples
sed -n '/^```console$/,/^```$/p' "$source/doc/examples/README.md" | grep -v '^```' >"$work/shown"
cd "$work/examples"
grep '^\$ ' "$work/shown" | while IFS= read -r line; do
    printf '%s\n' "$line"
    sh -c "${line#\$ }" 2>&1 || echo "exit code $?"
done >"$work/printed"
diff -u "$work/shown" "$work/printed" ||
    fail "doc/examples/README.md shows (-) something else than what is printed (+)"
grep -c '^\$ ' "$work/shown" | grep -q '^4$' || fail "four commands were to be run"
