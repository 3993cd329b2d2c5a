#include "core/session/section_names.h"

#include "core/io/listing.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace fff {

namespace {

struct SectionNamesTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::SectionNames)
};

/// Fewer read better each by its name.
constexpr std::size_t kLeastRun = 3;

/// A name that ends with a number.
struct NumberedName
{
    QString word;
    int number = -1; // none
};

NumberedName parsed(const QString &name)
{
    const qsizetype blank = name.lastIndexOf(u' ');
    bool isNumber = false;
    const int number = blank > 0 ? name.mid(blank + 1).toInt(&isNumber) : -1;
    // "Rib 07" and "Rib +7" are no Rib 7.
    if (!isNumber || number < 0 || QString::number(number) != name.mid(blank + 1))
        return {};
    return {name.left(blank), number};
}

/// More pieces than this say less than how many sections they are.
constexpr std::size_t kMostPieces = 4;

/// Numbers in order, "70–72" where at least kLeastRun count up.
std::vector<QString> pieces(const std::vector<int> &numbers)
{
    std::vector<QString> said;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1)
            ++end;
        if (end - i >= kLeastRun) {
            said.push_back(QStringLiteral("%1–%2").arg(numbers[i]).arg(numbers[end - 1]));
            i = end;
        } else {
            said.push_back(QString::number(numbers[i]));
            ++i;
        }
    }
    return said;
}

/// All sections of that word as one; empty where each reads better by its name.
QString runText(const QString &word, std::vector<int> numbers)
{
    std::sort(numbers.begin(), numbers.end());
    const std::vector<QString> said = pieces(numbers);
    const bool hasRun = said.size() + 1 < numbers.size();
    const bool isDouble = std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end();
    if (!hasRun || isDouble || said.size() > kMostPieces)
        return {};
    const QString all = separated(QStringList(said.begin(), said.end()));
    const QString first = QString::number(numbers.front());
    //: what the program calls a section that nobody has named; %1 is its number
    if (SectionNamesTexts::tr("Section %1").arg(first) == word + u' ' + first)
        //: several that nobody has named; %1 is such as "70–73" or "2, 5–8"
        return SectionNamesTexts::tr("Sections %1").arg(all);
    return word + u' ' + all;
}

} // namespace

QString sectionName(const Model &model, const SectionRef &ref)
{
    return QString::fromStdString(model.nameOf(ref));
}

QString listed(QStringList names)
{
    if (names.size() < 2)
        return names.join(QString());
    const QString last = names.takeLast();
    //: the end of a list of names
    return SectionNamesTexts::tr("%1 and %2").arg(separated(names), last);
}

QStringList inRuns(const QStringList &names)
{
    std::map<QString, std::vector<int>> numbersOf; // by the word
    for (const QString &name : names)
        if (const NumberedName known = parsed(name); known.number >= 0)
            numbersOf[known.word].push_back(known.number);
    std::map<QString, QString> runs;
    for (const auto &[word, numbers] : numbersOf)
        runs[word] = runText(word, numbers);
    QStringList said;
    std::set<QString> done;
    for (const QString &name : names) {
        const NumberedName known = parsed(name);
        const QString run = known.number >= 0 ? runs[known.word] : QString();
        if (run.isEmpty())
            said += name;
        else if (done.insert(known.word).second)
            said += run;
    }
    return said;
}

} // namespace fff
