#include "app/display/DisplayLibrary.h"

#include <dlfcn.h>

#include <filesystem>
#include <memory>
#include <string>

#include "filters/core/support/Error.h"

namespace umbra {

namespace fs = std::filesystem;

namespace {

constexpr const char* libraryName = "libumbrascope_display.so";

// The library is beside the program as it was built (bin, lib) or installed, or in the program's
// folder.
fs::path findLibrary() {
  std::error_code problem;
  const fs::path folder = fs::read_symlink("/proc/self/exe", problem).parent_path();
  for (const fs::path& candidate :
       {folder / ".." / "lib" / libraryName, folder / ".." / "lib" / "umbrascope" / libraryName,
        folder / libraryName})
    if (fs::exists(candidate)) return fs::weakly_canonical(candidate);
  throw Error(ErrorKind::NoOpenGL, std::string(libraryName) +
                                       ": is not installed beside the program; it is needed for "
                                       "windows, pictures and plots");
}

}  // namespace

std::unique_ptr<Display> loadDisplay() {
  const fs::path file = findLibrary();
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library)
    throw Error(ErrorKind::NoOpenGL, file.string() + ": cannot be loaded: " + dlerror());
  const auto make = reinterpret_cast<DisplayFactory>(dlsym(library, displayFactoryName));
  if (!make)
    throw Error(ErrorKind::NoOpenGL, file.string() + ": is not the library of this program");
  return std::unique_ptr<Display>(make());
}

}  // namespace umbra
