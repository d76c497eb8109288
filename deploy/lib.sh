# What the scripts of this folder share: sourced, with the project's folder as the working directory.
# shellcheck shell=bash disable=SC2034  # the scripts that source it use its variables

# Where the headers of Boost are unpacked if the installed Boost is another one (deploy/install).
readonly BOOST_UNPACKED=build/deps/boost
# Where the headers of PCL are unpacked (deploy/install; services/recognition/CMakeLists.txt looks there).
readonly PCL_UNPACKED=build/deps/pcl
# Where OpenCV's aruco module and the headers it needs are unpacked (the same).
readonly OPENCV_UNPACKED=build/deps/opencv

# ccache may use precompiled headers although it cannot see the macros in them: they are made from the same command lines.
export CCACHE_SLOPPINESS=pch_defines,time_macros

# die MESSAGE...: says what is wrong and leaves with status 1.
die() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# as_root COMMAND...: runs it with the rights to install packages.
as_root() {
  if ((EUID == 0)); then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo -- "$@"
  else
    die "installing packages needs root: run deploy/install as root once"
  fi
}

# configure PRESET [OPTION...]: configures build/PRESET.
configure() {
  local preset=$1 boost=()
  shift
  [[ -d $BOOST_UNPACKED/usr/include/boost ]] && boost=("-DBoost_ROOT=$PWD/$BOOST_UNPACKED/usr")
  cmake --preset "$preset" "${boost[@]}" "$@"
}

# web_build: the browser clients, into web/dist.
web_build() {
  (cd web && npm run build)
}
