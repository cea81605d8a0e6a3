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

# configure [CMAKE ARGUMENT...]: release build, without tests unless the arguments say so; ccache
# and the mold linker where present.
configure() {
  local options=(-DUMBRA_TESTS=OFF -DUMBRA_UNITY=ON)
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

# ccache keeps objects that were compiled with a precompiled header only where this is said.
export CCACHE_SLOPPINESS="${CCACHE_SLOPPINESS:-pch_defines,time_macros}"

# time_left SECONDS: "about 3 minutes", "less than a minute".
time_left() {
  local minutes=$((($1 + 30) / 60))
  case $minutes in
    0) printf 'less than a minute' ;;
    1) printf 'about a minute' ;;
    *) printf 'about %d minutes' "$minutes" ;;
  esac
}

# build [CMAKE ARGUMENT...]: builds, and says how far it is and how long it will take: on one line
# of a terminal, every 20 seconds elsewhere. What the compiler says is passed on.
build() {
  local line step steps left said=$SECONDS began=0 first=0
  NINJA_STATUS='[%f/%t] ' cmake --build --preset release "$@" 2>&1 | while IFS= read -r line; do
    case "$line" in
      '['*/*'] '*) ;;
      'ninja: no work to do.' | 'ninja: Entering directory'*) continue ;;
      *) printf '%s\n' "$line" >&2; continue ;;
    esac
    step=${line#[} step=${step%%]*} steps=${step#*/} step=${step%/*}
    # Texts are embedded first, which tells little of what compiling takes.
    if [ "$first" -eq 0 ]; then
      [[ $line == *'Building CXX'* ]] || continue
      first=$step began=$SECONDS
      [ "$steps" -lt 20 ] || say "Building in $steps steps on $(nproc) cores; the first time takes a while."
    fi
    left=''
    [ $((step - first)) -lt 10 ] ||
      left=", $(time_left $(((SECONDS - began) * (steps - step) / (step - first)))) left"
    if [ -t 2 ]; then
      printf '\r\033[K[%d/%d]%s' "$step" "$steps" "$left" >&2
    elif [ $((SECONDS - said)) -ge 20 ]; then
      said=$SECONDS
      say "[$step/$steps]$left"
    fi
  done
  local status=${PIPESTATUS[0]}
  [ ! -t 2 ] || printf '\r\033[K' >&2
  return "$status"
}
