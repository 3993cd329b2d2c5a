#include "core/session/section_names.h"

#include <QCoreApplication>

namespace fff {

namespace {

struct SectionNamesTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::SectionNames)
};

/// Fewer read better each by its name.
constexpr qsizetype kLeastRun = 3;

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

QString runText(const QString &word, int first, int last)
{
    const QString from = QString::number(first), to = QString::number(last);
    //: what the program calls a section that nobody has named; %1 is its number
    if (SectionNamesTexts::tr("Section %1").arg(from) == word + u' ' + from)
        //: several in a row that nobody has named; %1 and %2 are the first and the last number
        return SectionNamesTexts::tr("Sections %1–%2").arg(from, to);
    return QStringLiteral("%1 %2–%3").arg(word, from, to);
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
    return SectionNamesTexts::tr("%1 and %2").arg(names.join(QStringLiteral(", ")), last);
}

QStringList inRuns(const QStringList &names)
{
    QStringList said;
    for (qsizetype i = 0; i < names.size();) {
        const NumberedName first = parsed(names[i]);
        qsizetype count = 1;
        while (first.number >= 0 && i + count < names.size()) {
            const NumberedName next = parsed(names[i + count]);
            if (next.word != first.word || next.number != first.number + count)
                break;
            ++count;
        }
        if (count < kLeastRun) {
            said += names[i];
            ++i;
        } else {
            said += runText(first.word, first.number, first.number + static_cast<int>(count) - 1);
            i += count;
        }
    }
    return said;
}

} // namespace fff
