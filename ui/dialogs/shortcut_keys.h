// The shortcuts of all actions as a table of values, with what a new one would collide with. Pure:
// the editor shows it and writes what comes out of it to the settings.
#pragma once

#include "ui/actions/action_finder.h"

#include <QKeySequence>
#include <QList>
#include <QMap>
#include <QString>

namespace fff::ui {

/// A single key, with or without Shift, that types something: it works in the view only, so that
/// typing in fields stays free.
bool isTypingKey(const QKeySequence &keys);

class ShortcutKeys
{
public:
    /// As they are set now.
    explicit ShortcutKeys(const QList<ListedAction> &actions);

    QList<QKeySequence> of(const QString &id) const { return m_keys.value(id); }
    /// Differs from what the program has by itself.
    bool isChanged(const QString &id) const;

    /// The action that has these keys already, also as the beginning of a longer sequence or the
    /// other way round; empty for none.
    QString ownerOf(const QKeySequence &keys, const QString &exceptId) const;

    /// `keys` belong to this action now, and to no other.
    void assign(const QString &id, const QList<QKeySequence> &keys);
    void reset(const QString &id);

    /// Only what differs from the program's own is kept.
    void store() const;

private:
    QMap<QString, QList<QKeySequence>> m_own, m_keys; // by the ids of their actions
};

} // namespace fff::ui
