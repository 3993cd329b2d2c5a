// What people are told, as tests look at it.
#pragma once

#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/model/hint.h"
#include "core/operations/operation_words.h"

#include <string>

namespace fff {

/// For the messages of QCOMPARE.
inline char *toString(const Text &text)
{
    return QTest::toString(text.source ? text.source : "nothing");
}

namespace test {

/// The name in the place %1, %2, …; empty where there is none.
inline std::string nameIn(const Hint &hint, std::size_t place = 1)
{
    if (hint.words.arguments.size() < place)
        return {};
    const Named *named = std::get_if<Named>(&hint.words.arguments[place - 1]);
    return named ? named->name : std::string();
}

/// What the tool of an operation of that kind asks for; empty: nothing.
inline std::string roleAskedFor(const Hint &hint, const char *kind = "linear")
{
    for (const InputSpec &input : operationKind(kind)->inputs)
        if (!hint.words.arguments.empty() &&
            hint.words.arguments.front() == Argument(operationWord(input.prompt)))
            return input.role;
    return {};
}

} // namespace test

} // namespace fff
