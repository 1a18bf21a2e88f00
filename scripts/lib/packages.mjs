// What each kind of work needs from the system, as Debian 12 packages and as something that can be looked for.

const include = (path) => ({ file: `/usr/include/${path}` });
const program = (name) => ({ program: name });

const headers = [
  ['libcgal-dev', include('CGAL/version.h')],
  ['libeigen3-dev', include('eigen3/Eigen/Core')],
  ['libnanoflann-dev', include('nanoflann.hpp')],
  ['libgudhi-dev', include('gudhi/Simplex_tree.h')],
  ['libcli11-dev', include('CLI/CLI.hpp')],
  ['libfast-float-dev', include('fast_float/fast_float.h')],
  ['libtinyobjloader-dev', include('tiny_obj_loader.h')],
];
const builder = [
  ['cmake', program('cmake')],
  ['ninja-build', program('ninja')],
];
const native = [
  ['g++', program('g++')],
  ...builder,
  ...headers,
  ['libgmp-dev', null],
  ['libmpfr-dev', include('mpfr.h')],
  ['libgtest-dev', include('gtest/gtest.h')],
  ['libbenchmark-dev', include('benchmark/benchmark.h')],
];
const wasm = [...builder, ...headers, ['emscripten', program('emcc')]];
const style = [
  ['clang-format', program('clang-format')],
  ['clang-tidy', program('clang-tidy')],
];
// Without a font Chromium draws no text.
const browser = [
  ['chromium', program('chromium')],
  ['fonts-dejavu-core', null],
];

/** need -> [package, how to see it where there is no dpkg (null: cannot be seen)]. */
export const needs = { native, wasm, web: [], style, browser };

/** The packages of several needs, each once, in the order of first mention. */
export function packagesFor(names) {
  const found = new Map();
  for (const name of names) for (const [pkg, sign] of needs[name]) found.set(pkg, sign);
  return found;
}
