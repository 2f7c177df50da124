#!/usr/bin/env bash
# Installs the Debian or Ubuntu packages of a list that are missing, or says which they are when it may not.
# Usage: install_packages.sh LIST...
set -euo pipefail

missing=()
while read -r package; do
  # dpkg-query prints "install ok installed" for what is there, and fails for what it has never heard of.
  status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing+=("$package")
done < <(cat "$@")
[ ${#missing[@]} -gt 0 ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
  as_root=()
elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
  as_root=(sudo)
else
  echo "kappabench: missing packages; install them with: sudo apt-get install ${missing[*]}" >&2
  exit 2
fi
echo "installing ${missing[*]}" >&2
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
