#!/usr/bin/env bash
# Builds the page and serves it: clients/web/serve.sh [PORT]
set -euo pipefail
cd "$(dirname "$0")"
./build.sh
echo "http://localhost:${1:-8000}"
exec python3 -m http.server --bind localhost --directory ../target/web "${1:-8000}"
