// What a mutated source file includes: the points at which tools/mutate.py changes the program, all in one build. Mutant N is on when the
// environment variable CAROM_MUTANT is N. Without it the program is the original; with CAROM_MUTANT=-1 it also notes which
// points it reaches, and appends their numbers to the file CAROM_MUTANT_REACHED when it ends.
#pragma once
#pragma GCC system_header

#include <algorithm>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <utility>

namespace carom_mutant
{

inline constexpr int most_mutants = 10000;

/// By mutant: whether the mutated expression compiles for the types at hand, and whether it was evaluated. Zero before any constructor runs.
inline bool is_possible[most_mutants];
inline bool is_reached[most_mutants];

inline int chosen_mutant()
{
    const char* text = std::getenv("CAROM_MUTANT");
    return text ? std::atoi(text) : 0;
}

/// Defined before everything in a mutated file, so that its namespace-scope constants may ask.
inline const int chosen = chosen_mutant();

/// Writes at the end of the program. It has no heap memory: tests count what the heap gives.
struct ReachedFile
{
    ~ReachedFile()
    {
        const char* path = std::getenv("CAROM_MUTANT_REACHED");
        std::FILE* file = path && chosen < 0 ? std::fopen(path, "a") : nullptr;
        if (!file) return;
        for (int i = 0; i < most_mutants; ++i)
            if (is_possible[i]) std::fprintf(file, "%d %d\n", i, is_reached[i] ? 1 : 0);
        std::fclose(file);
    }
};
inline ReachedFile reached_file;

template <int N>
inline const bool noted = (is_possible[N] = true);

template <int N>
bool is_chosen()
{
    (void)&noted<N>;
    if (chosen == N) [[unlikely]]
        return true;
    if (chosen < 0) [[unlikely]]
        is_reached[N] = true;
    return false;
}

/// False where the compiler evaluates: a constant expression can't ask the environment.
template <int N>
constexpr bool active()
{
    if (std::is_constant_evaluated()) return false;
    return is_chosen<N>();
}

// Binary operators: `a + b` becomes `a + Tag<N, Plus, Minus>{} + b`, which parses as the original does, whatever a and b are.
template <int N, class Original, class Mutated>
struct Tag
{
};

template <class L, int N, class Original, class Mutated>
struct Left
{
    const L& value;
};

template <int N, class Original, class Mutated, class L, class R>
constexpr auto apply(const L& left, const R& right)
{
    using Result = decltype(Original::of(left, right));
    if constexpr (requires {
                      { Mutated::of(left, right) } -> std::same_as<Result>;
                  })
    {
        if (active<N>()) return Mutated::of(left, right);
    }
    return Original::of(left, right);
}

#define CAROM_MUTANT_OPERATOR(Name, symbol)                                                                                                \
    struct Name                                                                                                                            \
    {                                                                                                                                      \
        template <class L, class R>                                                                                                        \
        static constexpr auto of(const L& left, const R& right) -> decltype(left symbol right)                                             \
        {                                                                                                                                  \
            return left symbol right;                                                                                                      \
        }                                                                                                                                  \
    };                                                                                                                                     \
    template <class L, int N, class Mutated>                                                                                               \
    constexpr Left<L, N, Name, Mutated> operator symbol(const L& left, Tag<N, Name, Mutated>)                                              \
    {                                                                                                                                      \
        return {left};                                                                                                                     \
    }                                                                                                                                      \
    template <class L, int N, class Mutated, class R>                                                                                      \
    constexpr auto operator symbol(Left<L, N, Name, Mutated> left, const R& right)                                                         \
    {                                                                                                                                      \
        return apply<N, Name, Mutated>(left.value, right);                                                                                 \
    }

CAROM_MUTANT_OPERATOR(Plus, +)
CAROM_MUTANT_OPERATOR(Minus, -)
CAROM_MUTANT_OPERATOR(Times, *)
CAROM_MUTANT_OPERATOR(Divide, /)
CAROM_MUTANT_OPERATOR(Modulo, %)
CAROM_MUTANT_OPERATOR(BitAnd, &)
CAROM_MUTANT_OPERATOR(BitOr, |)
CAROM_MUTANT_OPERATOR(Less, <)
CAROM_MUTANT_OPERATOR(LessEqual, <=)
CAROM_MUTANT_OPERATOR(Greater, >)
CAROM_MUTANT_OPERATOR(GreaterEqual, >=)
CAROM_MUTANT_OPERATOR(Equal, ==)
CAROM_MUTANT_OPERATOR(NotEqual, !=)
#undef CAROM_MUTANT_OPERATOR

// Unary operators: `-x` becomes `Negate<N>{} ->* x`; ->* binds looser than what is unary and tighter than all else.
template <int N>
struct Negate
{
};
template <int N, class T>
constexpr auto operator->*(Negate<N>, const T& value)
{
    using Result = decltype(-value);
    if (active<N>()) return static_cast<Result>(value);
    return static_cast<Result>(-value);
}

template <int N>
struct Not
{
};
template <int N, class T>
constexpr bool operator->*(Not<N>, const T& value)
{
    return active<N>() == !static_cast<bool>(value) ? false : true;
}

/// A literal of a function.
template <int N, class T>
constexpr T constant(T original, T mutated)
{
    return active<N>() ? mutated : original;
}

/// A named constant, which is no constant expression then.
template <int N, class T>
T tuned(T original, T mutated)
{
    return is_chosen<N>() ? mutated : original;
}

/// A returned value: a bool is negated, a number becomes 0 or, when it is 0, 1; what is made for the return becomes a default value.
template <int N, class T>
constexpr decltype(auto) returned(T&& value)
{
    using Value = std::remove_cvref_t<T>;
    if constexpr (std::is_same_v<Value, bool>)
        return active<N>() ? !value : static_cast<bool>(value);
    else if constexpr (std::is_arithmetic_v<Value>)
        return active<N>() ? static_cast<Value>(value == Value{}) : static_cast<Value>(value);
    else if constexpr (!std::is_lvalue_reference_v<T> && std::is_default_constructible_v<Value> && std::is_move_constructible_v<Value>)
        return active<N>() ? Value{} : Value(std::forward<T>(value));
    else
        return std::forward<T>(value);
}

} // namespace carom_mutant

/// A call of one function in place of another.
#define CAROM_MUTANT_CALL(n, original, mutated, ...) (::carom_mutant::active<n>() ? mutated(__VA_ARGS__) : original(__VA_ARGS__))
