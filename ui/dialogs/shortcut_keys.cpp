#include "ui/dialogs/shortcut_keys.h"

#include "ui/actions/action_set.h"
#include "ui/settings/settings.h"

namespace fff::ui {

bool isTypingKey(const QKeySequence &keys)
{
    if (keys.isEmpty())
        return false;
    const QKeyCombination first = keys[0];
    const Qt::KeyboardModifiers held = first.keyboardModifiers() & ~Qt::KeypadModifier;
    // Above these are keys without a character: Home, F1, media keys.
    return (held == Qt::NoModifier || held == Qt::ShiftModifier) && first.key() < Qt::Key_Escape;
}

ShortcutKeys::ShortcutKeys(const QList<ListedAction> &actions)
{
    for (const ListedAction &each : actions) {
        if (!each.action || !ActionSet::isOfCommand(each.action))
            continue;
        m_own.insert(each.id, ActionSet::ownShortcuts(each.action));
        m_keys.insert(each.id, each.action->shortcuts());
    }
}

bool ShortcutKeys::isChanged(const QString &id) const
{
    return of(id) != m_own.value(id);
}

QString ShortcutKeys::ownerOf(const QKeySequence &keys, const QString &exceptId) const
{
    for (auto it = m_keys.begin(); it != m_keys.end(); ++it) {
        if (it.key() == exceptId)
            continue;
        for (const QKeySequence &taken : it.value()) {
            if (taken.matches(keys) != QKeySequence::NoMatch ||
                keys.matches(taken) != QKeySequence::NoMatch)
                return it.key();
        }
    }
    return {};
}

void ShortcutKeys::assign(const QString &id, const QList<QKeySequence> &keys)
{
    for (const QKeySequence &wanted : keys) {
        for (QString owner = ownerOf(wanted, id); !owner.isEmpty(); owner = ownerOf(wanted, id)) {
            m_keys[owner].removeIf([&wanted](const QKeySequence &taken) {
                return taken.matches(wanted) != QKeySequence::NoMatch ||
                       wanted.matches(taken) != QKeySequence::NoMatch;
            });
        }
    }
    m_keys.insert(id, keys);
}

void ShortcutKeys::reset(const QString &id)
{
    assign(id, m_own.value(id));
}

void ShortcutKeys::store() const
{
    for (auto it = m_keys.begin(); it != m_keys.end(); ++it) {
        const bool isOwn = !isChanged(it.key());
        settings().setShortcuts(it.key(), isOwn ? std::nullopt : std::optional(it.value()));
    }
}

} // namespace fff::ui
