// The functions of expressions.
#pragma once

#include <span>
#include <string_view>

namespace fff {

enum class Function {
    If, // condition, what it is then, what it is else
    Min,
    Max,
    Round, // to whole numbers, or to steps of the second one; halves away from 0
    Floor,
    Ceil,
    Sqrt,
    Abs,
    Sin, // of an angle, or of degrees
    Cos,
    Tan,
    Asin, // an angle
    Acos,
    Atan,
    And,
    Or,
    Not,
    Len, // how many letters the longest line of a text has
};

struct FunctionName
{
    Function function = Function::If;
    std::string_view name;
    int least = 1, most = 1; // arguments
};

inline constexpr int kMostArguments = 100;

std::span<const FunctionName> functionNames();
/// In functionNames(), or -1. Capitals or not are the same.
int findFunction(std::string_view name);

} // namespace fff
