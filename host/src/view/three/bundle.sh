#!/bin/sh
# Makes three.min.js from npm's three 0.187.0 with esbuild 0.28.2, and says whether it is the committed one.
# No build runs this: it is for who wants a newer version, or to see that the file is what it claims to be.
set -eu
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp entry.js "$folder/"
(cd "$folder" && npm init -y >/dev/null && npm install --silent three@0.187.0 esbuild@0.28.2 &&
    npx esbuild entry.js --bundle --minify --format=iife --global-name=THREE --legal-comments=none --outfile=three.min.js)
cp "$folder/three.min.js" "$folder/node_modules/three/LICENSE" .
sha256sum --check three.sha256
