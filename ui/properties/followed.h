// What a field's number follows, where it can follow an expression: who knows that, and who makes
// it so.
#pragma once

#include <QString>
#include <QStringList>

#include <functional>

namespace fff::ui {

struct Followed
{
    /// As it was typed, without "="; empty: nothing, it is a number by itself.
    std::function<QString()> typed;
    /// From now on it follows this. What comes back says why it cannot; empty: it does.
    std::function<QString(const QString &text)> follow;
    /// It is a number by itself from now on.
    std::function<void()> release;
    /// What can be named in it.
    std::function<QStringList()> names;

    explicit operator bool() const { return static_cast<bool>(follow); }
};

} // namespace fff::ui
