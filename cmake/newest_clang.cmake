# A toolchain: the newest clang that is installed. Carom needs clang 19 or newer.
find_program(CMAKE_CXX_COMPILER NAMES clang++-25 clang++-24 clang++-23 clang++-22 clang++-21 clang++-20 clang++-19 clang++ REQUIRED)
