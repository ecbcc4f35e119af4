# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by app/demo.sh and tests/run.sh from the repository's root: installs what of app/packages.txt is
# missing; install_packages does so for another list. Where nothing is, neither apt nor the network is touched.

give_up() {
  echo "bedmix: $*" >&2
  exit 1
}

install_packages() { # LIST
  local wanted present missing as_root=()
  wanted=$(sed 's/#.*//' "$1")
  command -v dpkg-query >/dev/null || give_up "this is no Debian system; install the packages of $1 by hand"
  # shellcheck disable=SC2086  # a list of words
  present=$(dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' $wanted 2>/dev/null | sed -n 's/^.i *//p') || true
  # shellcheck disable=SC2086
  missing=$(comm -23 <(printf '%s\n' $wanted | sort -u) <(printf '%s\n' $present | sort -u) | tr '\n' ' ')
  [[ -n $missing ]] || return 0

  if ((EUID != 0)); then
    command -v sudo >/dev/null || give_up "missing packages and neither root nor sudo: $missing"
    as_root=(sudo)
  fi
  echo "bedmix: installing $missing" >&2
  "${as_root[@]}" apt-get update -qq || give_up "apt-get update failed (no network?); missing: $missing"
  # shellcheck disable=SC2086
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null ||
    give_up "apt-get could not install: $missing"
}

install_packages app/packages.txt
