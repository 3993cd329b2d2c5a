#include "ui/properties/kept_number.h"

#include <cmath>

namespace fff::ui {

namespace {

constexpr int kKeptField = 72; // px

} // namespace

KeptNumber addKeptNumber(PropertyGroup &group, const QString &name, const char *id,
                         const KeptRange &range, int *kept)
{
    auto *edit = new NumberEdit({double(range.least), double(range.most), 1.0, 0, 0}, range.unit);
    edit->setFixedWidth(kKeptField);
    auto *field = new SliderField({double(range.least), double(range.slid), 1.0, range.notches},
                                  edit, &group);
    field->setNames((QByteArray(id) + "Slider").constData(),
                    (QByteArray(id) + ".field").constData());
    field->setNumber(*kept);
    const auto keep = [kept](double value) { *kept = static_cast<int>(std::lround(value)); };
    QObject::connect(field, &SliderField::dragged, field, keep);
    QObject::connect(field, &SliderField::settled, field, keep);
    auto *row = new EditorRow(name, id, field, {}, &group);
    group.add(row);
    return {row, field};
}

} // namespace fff::ui
