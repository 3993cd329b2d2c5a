#include "core/values/function_names.h"

#include "core/base/letters.h"

namespace fff {

namespace {

constexpr FunctionName kFunctionNames[] = {
    {Function::If, "if", 3, 3},
    {Function::Min, "min", 2, kMostArguments},
    {Function::Max, "max", 2, kMostArguments},
    {Function::Round, "round", 1, 2},
    {Function::Floor, "floor", 1, 2},
    {Function::Ceil, "ceil", 1, 2},
    {Function::Sqrt, "sqrt", 1, 1},
    {Function::Abs, "abs", 1, 1},
    {Function::Sin, "sin", 1, 1},
    {Function::Cos, "cos", 1, 1},
    {Function::Tan, "tan", 1, 1},
    {Function::Asin, "asin", 1, 1},
    {Function::Acos, "acos", 1, 1},
    {Function::Atan, "atan", 1, 1},
    {Function::And, "and", 2, kMostArguments},
    {Function::Or, "or", 2, kMostArguments},
    {Function::Not, "not", 1, 1},
    {Function::Len, "len", 1, 1},
};

} // namespace

std::span<const FunctionName> functionNames()
{
    return kFunctionNames;
}

int findFunction(std::string_view name)
{
    const std::string sought = foldedName(name);
    for (std::size_t i = 0; i < std::size(kFunctionNames); ++i)
        if (kFunctionNames[i].name == sought)
            return static_cast<int>(i);
    return -1;
}

} // namespace fff
