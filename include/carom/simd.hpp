// Which instruction set the solver uses. It changes how fast a step is, and nothing else: all give the same bits.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace carom
{

enum class Simd
{
    Best,   ///< Avx2 where this machine has it, else Four; or what the environment variable CAROM_SIMD names: the default
    Scalar, ///< one number at a time: the reference
    Four,   ///< four at a time: SSE2, NEON or WebAssembly's SIMD, whichever the build is for
    Avx2,   ///< eight at a time; x86-64 only
    Avx512  ///< sixteen at a time; x86-64 only. No faster than Avx2 where it was measured
};

/// Those that say what is used, from the narrowest to the widest.
inline constexpr std::array all_simd = {Simd::Scalar, Simd::Four, Simd::Avx2, Simd::Avx512};

/// "best", "scalar", "avx2", "avx512"; of Four what it is in this build: "sse2", "neon", "wasm" or "four".
std::string_view name_of(Simd simd);
/// The one that name_of gives this name; empty when there is none in this build.
std::optional<Simd> simd_named(std::string_view name);
/// Whether this build has it and this machine can run it.
bool is_available(Simd simd);
/// What Simd::Best stands for, the environment aside.
Simd best_simd();

} // namespace carom
