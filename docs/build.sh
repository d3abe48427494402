#!/usr/bin/env bash
# Builds the site into out/site/html; installs missing Debian packages first.
#   docs/build.sh          builds the library if it is not there, then the pages
#   docs/build.sh look     and opens every page in Chromium, on a wide and a narrow screen: broken links and pictures, text that
#                          runs out of the screen, errors of scripts; screenshots go to out/site/look
# BEMPD_LIBRARY names a library that is built already.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

# Debian's own tools before others of the same name.
export PATH="/usr/bin:/bin:$PATH"
packages=(gcc python3 python3-sphinx python3-myst-parser furo python3-sphinx-copybutton libjs-mathjax node-normalize.css python3-pycparser python3-cffi
  python3-numpy python3-matplotlib python3-pil cargo rustc)
if [ "${1:-}" = look ]; then packages+=(chromium); fi
.ci/require_packages.sh "${packages[@]}"

library=${BEMPD_LIBRARY:-}
for built in build/ci build/release; do
  if [ -z "$library" ] && [ -e "$built/src/capi/libbempd.so" ]; then library="$root/$built/src/capi/libbempd.so"; fi
done
if [ -z "$library" ]; then
  .ci/require_packages.sh cmake ninja-build g++ libeigen3-dev libsuitesparse-dev libopenblas-dev
  cmake --preset release -Wno-dev >/dev/null
  cmake --build --preset release -j "$(nproc)" --target bempd
  library="$root/build/release/src/capi/libbempd.so"
fi
export BEMPD_LIBRARY="$library" PYTHONDONTWRITEBYTECODE=1

python3 docs/options.py --check
python3 docs/site/stage.py . out/site/source
python3 docs/site/reference.py . out/site/source/docs/reference
rm -rf out/site/html
PYTHONPATH="$root/bindings/python" python3 -m sphinx -q -W --keep-going -b html out/site/source out/site/html
# Debian's theme takes this style from the web server; the site is to stand alone.
cp /usr/share/javascript/normalize.css/normalize.css out/site/html/_static/styles/
sed -i 's|/javascript/normalize.css/normalize.css|normalize.css|' out/site/html/_static/styles/*.css
printf '<!doctype html><meta charset="utf-8"><meta http-equiv="refresh" content="0; url=docs/index.html"><title>bempd</title>\n' \
  >out/site/html/index.html
# rustdoc writes the crate's own pages; it needs no library.
(cd bindings/rust && BEMPD_LIB_DIR=$(dirname "$library") cargo doc -q --offline --no-deps --target-dir "$root/out/site/rust")
cp -r out/site/rust/doc out/site/html/rust
echo "the site: out/site/html/docs/index.html"
if [ "${1:-}" = look ]; then python3 docs/site/look.py out/site/html out/site/look; fi
