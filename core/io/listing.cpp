#include "core/io/listing.h"

#include <QCoreApplication>

namespace fff {

namespace {

struct ListingTexts
{
    Q_DECLARE_TR_FUNCTIONS(Listing)
};

QString separator()
{
    //: between the entries of a list in a sentence, with its blank
    return ListingTexts::tr(", ");
}

} // namespace

QString separated(const QStringList &list)
{
    return list.join(separator());
}

QString io::enumerated(const QStringList &list, const QString &lastTwo, const QString &between)
{
    if (list.size() < 2)
        return list.join(QString());
    const QStringList first = list.mid(0, list.size() - 1);
    return lastTwo.arg(between.isEmpty() ? separated(first) : first.join(between), list.last());
}

} // namespace fff
