# SPDX-License-Identifier: Apache-2.0
# For the shell scripts of this project: installs what is missing of some sections of cmake/packages.txt.
# Words for people go to stderr; apt-get's own output is shown only if it fails.

# The packages of the sections $1 $2 ... , one a line.
packages_of() {
    awk -v wanted=" $* " '/^\[/ { name = $1; gsub(/[][]/, "", name); on = index(wanted, " " name " "); next } on && NF && !/^#/ { print $1 }' \
        "$root/cmake/packages.txt"
}

# Those of the words that dpkg does not call installed.
missing_packages() {
    dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
        awk -v all="$*" '$1 == "installed" { have[$2] } END { n = split(all, p, " "); for (i = 1; i <= n; ++i) if (!(p[i] in have)) print p[i] }'
}

# How to become root without a question that nobody can answer; fails if there is no way.
root_prefix() {
    if [ "$(id -u)" = 0 ]; then echo env
    elif sudo -n true 2>/dev/null || { [ -t 0 ] && [ -t 2 ] && command -v sudo >/dev/null; }; then echo sudo
    else return 1; fi
}

# need_packages SECTION...: returns once they are all installed, ends the script if that cannot be.
need_packages() {
    command -v dpkg-query >/dev/null || return 0   # not Debian: CMake will say what it does not find
    local missing as_root log size
    mapfile -t missing < <(missing_packages $(packages_of "$@"))
    [ ${#missing[@]} -gt 0 ] || return 0
    if ! as_root=$(root_prefix); then
        echo "alidade: ${#missing[@]} Debian packages are missing; install them with" >&2
        echo "  sudo apt-get update && sudo apt-get install -y --no-install-recommends ${missing[*]}" >&2
        exit 1
    fi
    log=$(mktemp)
    echo "alidade: looking up ${#missing[@]} missing Debian packages (apt-get update)" >&2
    if ! $as_root apt-get update >"$log" 2>&1 </dev/null; then cat "$log" >&2; fi   # older lists may do
    # `apt-get --assume-no` always fails: it must not end a caller that stops at the first error.
    size=$(apt-get install --assume-no --no-install-recommends "${missing[@]}" 2>/dev/null | sed -n 's/^Need to get \(.*\) of archives.*/\1/p') || true
    echo "alidade: installing them (${size:-size unknown} to download): ${missing[*]}" >&2
    if ! $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}" >"$log" 2>&1 </dev/null; then
        cat "$log" >&2
        echo "alidade: apt-get failed (above)" >&2
        rm -f "$log"
        exit 1
    fi
    rm -f "$log"
}
