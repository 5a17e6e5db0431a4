// The program carom-gallery.
#include "gallery/app.hpp"

#include <iostream>
#include <string>
#include <vector>

int main(int argc, char** argv)
{
    return carom::gallery::run_gallery(std::vector<std::string>(argv + 1, argv + argc), std::cout, std::cerr);
}
