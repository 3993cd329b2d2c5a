// The models that come with the program. Each is opened as a copy.
#pragma once

#include <QList>
#include <QString>

namespace fff::ui {

struct Sample
{
    QString name; // in the person's language
    QString path; // :/samples/…
};

QList<Sample> samples();

} // namespace fff::ui
