# SPDX-License-Identifier: GPL-3.0-or-later
# To be sourced: the help of a script is the comment at its head.

# Without its licence.
print_help() { awk 'NR > 2 && !/^#/ { exit } NR > 2 { sub(/^# ?/, ""); print }' "$0"; }

# Ends the script after it where an argument asks for it.
help_if_asked() {
  local argument
  for argument; do
    case $argument in
      -h | --help) print_help && exit 0 ;;
    esac
  done
}
