# Shared by `run` and `test`: installs missing packages, configures, builds. Sourced, not run.
# Everything is said on standard error, so that what the program prints stays clean.

say() { printf '%s\n' "$*" >&2; }

# packages_of SECTION...: the package names of those sections of the list.
packages_of() {
  local section="" line
  while IFS= read -r line; do
    case "$line" in
      \#* | "") ;;
      \[*\]) section="${line//[\[\]]/}" ;;
      *) [[ " $* " == *" $section "* ]] && printf '%s\n' "$line" ;;
    esac
  done < cmake/debian-packages.txt
}

# install_missing SECTION...: nothing at all when everything is there.
install_missing() {
  local missing=() package
  for package in $(packages_of "$@"); do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      say "These Debian packages are missing and there is no sudo to install them: ${missing[*]}"
      exit 1
    }
    as_root=(sudo)
  fi
  say "Installing ${#missing[@]} Debian packages: ${missing[*]}"
  "${as_root[@]}" apt-get update -q >&2 &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get install -q -y --no-install-recommends "${missing[@]}" >&2 || {
    say "The packages could not be installed; the lines above say why."
    exit 1
  }
}

# configure [CMAKE ARGUMENT...]: release build, ccache and the mold linker where present.
configure() {
  local options=()
  command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  command -v mold >/dev/null && options+=(-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=mold
    -DCMAKE_SHARED_LINKER_FLAGS=-fuse-ld=mold -DCMAKE_MODULE_LINKER_FLAGS=-fuse-ld=mold)
  # CMake's own report is long; it is shown only when something is wrong.
  mkdir -p build
  cmake --preset release "${options[@]}" "$@" > build/configure.log 2>&1 || {
    cat build/configure.log >&2
    exit 1
  }
}
