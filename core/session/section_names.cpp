#include "core/session/section_names.h"

#include <QCoreApplication>

namespace fff {

namespace {

struct SectionNamesTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::SectionNames)
};

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

} // namespace fff
