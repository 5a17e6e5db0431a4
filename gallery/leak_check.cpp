// Everything here is for builds with the address sanitizer.
#include "gallery/leak_check.hpp"

#ifdef __SANITIZE_ADDRESS__

#include <dlfcn.h>
#include <link.h>
#include <string>
#include <vector>

/// SDL asks the desktop over D-Bus and Cairo finds letters through Fontconfig, and both keep what they have read: not leaks of ours. Weak,
/// since a program that holds other parts of Carom may have a list already.
extern "C" [[gnu::weak]] const char* __lsan_default_suppressions() { return "leak:libdbus\nleak:libfontconfig"; }

void carom::gallery::keep_libraries_loaded()
{
    std::vector<std::string> names;
    const auto add_name = [](dl_phdr_info* library, std::size_t, void* list)
    {
        if (library->dlpi_name && *library->dlpi_name) static_cast<std::vector<std::string>*>(list)->emplace_back(library->dlpi_name);
        return 0;
    };
    dl_iterate_phdr(add_name, &names);
    for (const std::string& name : names)
    {
        if (void* const library = dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE)) dlclose(library);
    }
}

#else

void carom::gallery::keep_libraries_loaded() {}

#endif
