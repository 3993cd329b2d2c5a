#include "ui/actions/action_finder.h"

#include "ui/actions/search_words.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

#include <algorithm>

namespace fff::ui {

namespace {

// Points a word.
constexpr int kWordStart = 8, kInName = 5, kOtherWord = 3, kElsewhere = 2, kInSentence = 1;
constexpr int kLeastScattered = 3; // letters; fewer are in every name and sentence

QString withoutMarks(QString text)
{
    // "&&" is a real one, a single one marks the letter to press.
    text.replace(QStringLiteral("&&"), QStringLiteral("\1"));
    text.remove(u'&');
    text.replace(u'\1', u'&');
    return text;
}

/// Lower case, accents taken off.
QString folded(const QString &text)
{
    QString result;
    for (const QChar c : text.normalized(QString::NormalizationForm_D)) {
        if (c.category() != QChar::Mark_NonSpacing)
            result += c.toLower();
    }
    return result;
}

void list(const QMenu &menu, const QString &path, QList<ListedAction> *result)
{
    for (QAction *action : menu.actions()) {
        if (action->isSeparator() || !action->isVisible())
            continue;
        const QString name = withoutMarks(action->text());
        if (action->menu())
            list(*action->menu(), path + QStringLiteral(" › ") + name, result);
        else
            result->append({action, name, path, action->objectName(), action->whatsThis(),
                            searchWordsOf(action->objectName())});
    }
}

bool startsAWord(const QString &text, const QString &word)
{
    for (qsizetype at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1)) {
        if (at == 0 || !text.at(at - 1).isLetterOrNumber())
            return true;
    }
    return false;
}

/// A choice of Mirror, as its bar has it, while nobody holds it: that itself is found by the same
/// words.
bool isOutOfHand(const ListedAction &action)
{
    const bool isChoice = action.id.startsWith(QStringLiteral("mirror.")) ||
                          action.id.startsWith(QStringLiteral("edit.mirrorCopy"));
    return isChoice && action.action && !action.action->isEnabled();
}

bool isScattered(const QString &text, const QString &word)
{
    if (word.size() < kLeastScattered)
        return false;
    qsizetype at = 0;
    for (const QChar c : word) {
        at = text.indexOf(c, at);
        if (at < 0)
            return false;
        ++at;
    }
    return true;
}

} // namespace

QList<ListedAction> listedActions(const QMenuBar &menus)
{
    QList<ListedAction> result;
    for (const QAction *action : menus.actions()) {
        if (action->menu())
            list(*action->menu(), withoutMarks(action->text()), &result);
    }
    return result;
}

int matchScore(const QString &query, const ListedAction &action)
{
    static const QRegularExpression blanks(QStringLiteral("\\s+"));
    const QString name = folded(action.name), other = folded(action.menuPath) + u' ' + action.id;
    const QString sentence = folded(action.does), also = folded(action.also);
    const QStringList words = folded(query).split(blanks, Qt::SkipEmptyParts);
    int score = !words.isEmpty() && name.startsWith(words.join(u' ')) ? kWordStart : 0;
    bool isGuess = false;
    for (const QString &word : words) {
        if (startsAWord(name, word))
            score += kWordStart;
        else if (name.contains(word))
            score += kInName;
        else if (startsAWord(also, word))
            score += kOtherWord;
        else if (other.contains(word, Qt::CaseInsensitive))
            score += kElsewhere;
        else if (word.size() >= kLeastScattered && startsAWord(sentence, word))
            score += kInSentence;
        else if (isScattered(name, word))
            isGuess = true;
        else
            return -1;
    }
    return isGuess ? 0 : score;
}

QList<ListedAction> foundActions(const QString &query, const QList<ListedAction> &actions)
{
    QList<std::pair<int, ListedAction>> scored;
    for (const ListedAction &action : actions) {
        const int score = isOutOfHand(action) ? -1 : matchScore(query, action);
        if (score >= 0)
            scored.append({score, action});
    }
    std::stable_sort(scored.begin(), scored.end(),
                     [](const auto &a, const auto &b) { return a.first > b.first; });
    QList<ListedAction> result;
    for (const auto &[score, action] : scored) {
        if (score > 0 || scored.front().first == 0)
            result += action;
    }
    return result;
}

} // namespace fff::ui
