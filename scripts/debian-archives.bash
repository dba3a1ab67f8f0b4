# SPDX-License-Identifier: GPL-3.0-or-later
# To be sourced: where a Debian archive is, for scripts that fetch from suites that this machine does not run.
#   CURVDECIM_DEBIAN_ARCHIVE   address of a Debian archive, where apt's own configuration has none (Ubuntu)

# The addresses of the configured archives with a "main" component, whatever form the lists have.
configured_archives() {
  if [ -n "${CURVDECIM_DEBIAN_ARCHIVE:-}" ]; then
    echo "$CURVDECIM_DEBIAN_ARCHIVE"
    return
  fi
  apt-get indextargets --format "\$(COMPONENT) \$(RELEASE) \$(REPO_URI)" 'Created-By: Packages' |
    awk '$1 == "main" && $2 !~ /security/ && !seen[$3]++ { print $3 }'
}

debian_keyring() {
  local keyring
  for keyring in /usr/share/keyrings/debian-archive-keyring.{gpg,pgp}; do
    if [ -r "$keyring" ]; then
      echo "$keyring"
      return
    fi
  done
  echo "no Debian archive keyring (apt-get install debian-archive-keyring)" >&2
  return 1
}
