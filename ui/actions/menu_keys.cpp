#include "ui/actions/menu_keys.h"

#include <QHash>
#include <QSet>

#include <algorithm>
#include <utility>
#include <vector>

namespace fff::ui {

namespace {

/// Behind a single '&'; null: there is none.
QChar keyOf(const QString &text)
{
    for (qsizetype at = text.indexOf(u'&'); at >= 0 && at + 1 < text.size();
         at = text.indexOf(u'&', at + 2))
        if (text[at + 1] != u'&')
            return text[at + 1].toLower();
    return {};
}

bool isLatin(QChar c)
{
    return c.isLetter() && c.script() == QChar::Script_Latin;
}

/// Letters that stand on no key of a Latin keyboard.
bool isOfOtherWriting(const QString &text)
{
    return std::any_of(text.begin(), text.end(),
                       [](QChar c) { return c.isLetter() && c.script() != QChar::Script_Latin; });
}

QString withKeyBehind(const QString &text, QChar key)
{
    const QString mark = QStringLiteral("(&%1)").arg(key.toUpper());
    return text.endsWith(u'…') ? text.chopped(1) + mark + u'…' : text + mark;
}

/// The keys that a text can have, the best one first.
std::vector<QChar> keysFor(const QString &text, const QString &source)
{
    const QChar wanted = keyOf(source);
    const bool isOther = isOfOtherWriting(text);
    const QString &letters = isOther ? source : text;
    std::vector<std::pair<int, QChar>> worths;
    for (qsizetype at = 0; at < letters.size(); ++at) {
        const QChar key = letters[at].toLower();
        const bool isKnown = std::any_of(worths.begin(), worths.end(),
                                         [key](const auto &one) { return one.second == key; });
        if (!isLatin(key))
            continue;
        const bool beginsWord = at == 0 || !letters[at - 1].isLetter();
        const int worth = (beginsWord ? 1 : 0) + (key == wanted ? 2 : 0);
        if (!isKnown)
            worths.emplace_back(worth, key);
        for (auto &one : worths)
            if (one.second == key)
                one.first = std::max(one.first, worth);
    }
    std::stable_sort(worths.begin(), worths.end(),
                     [](const auto &x, const auto &y) { return x.first > y.first; });
    std::vector<QChar> keys;
    for (const auto &one : worths)
        keys.push_back(one.second);
    return keys;
}

QString withKey(const QString &text, QChar key)
{
    if (isOfOtherWriting(text))
        return withKeyBehind(text, key);
    qsizetype place = -1;
    for (qsizetype at = 0; at < text.size(); ++at)
        if (text[at].toLower() == key && (place < 0 || at == 0 || !text[at - 1].isLetter())) {
            place = at;
            if (at == 0 || !text[at - 1].isLetter())
                break;
        }
    return QString(text).insert(place, u'&');
}

/// Gives each text one of its keys, no two the same, and as many as there can be: one that has no
/// other choice takes a key from one that has (a matching by augmenting paths, Kuhn 1955).
class KeyGiver
{
public:
    explicit KeyGiver(std::vector<std::vector<QChar>> wishes) : m_wishes(std::move(wishes)) {}

    /// By text; null: none was left.
    std::vector<QChar> given()
    {
        for (std::size_t text = 0; text < m_wishes.size(); ++text) {
            QSet<QChar> tried;
            give(text, tried);
        }
        std::vector<QChar> keys(m_wishes.size());
        for (auto owner = m_owners.cbegin(); owner != m_owners.cend(); ++owner)
            keys[owner.value()] = owner.key();
        return keys;
    }

private:
    bool give(std::size_t text, QSet<QChar> &tried)
    {
        for (const QChar key : m_wishes[text])
            if (!m_owners.contains(key)) {
                m_owners.insert(key, text);
                return true;
            }
        for (const QChar key : m_wishes[text]) {
            if (tried.contains(key))
                continue;
            tried.insert(key);
            if (give(m_owners.value(key), tried)) {
                m_owners.insert(key, text);
                return true;
            }
        }
        return false;
    }

    std::vector<std::vector<QChar>> m_wishes;
    QHash<QChar, std::size_t> m_owners;
};

} // namespace

QStringList withMenuKeys(const QStringList &texts, const QStringList &sources)
{
    QSet<QChar> taken;
    for (const QString &text : texts)
        if (const QChar key = keyOf(text); !key.isNull())
            taken.insert(key);
    std::vector<std::vector<QChar>> wishes;
    for (qsizetype i = 0; i < texts.size(); ++i) {
        wishes.emplace_back();
        if (!keyOf(texts[i]).isNull())
            continue;
        for (const QChar key : keysFor(texts[i], sources[i]))
            if (!taken.contains(key))
                wishes.back().push_back(key);
    }
    const std::vector<QChar> keys = KeyGiver(std::move(wishes)).given();
    QStringList marked;
    for (qsizetype i = 0; i < texts.size(); ++i) {
        const QChar key = keys[static_cast<std::size_t>(i)];
        marked += key.isNull() ? texts[i] : withKey(texts[i], key);
    }
    return marked;
}

} // namespace fff::ui
