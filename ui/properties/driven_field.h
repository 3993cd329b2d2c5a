// Number fields whose number follows an expression: of a place of the document, or of a value. One
// line where the field is made says which.
#pragma once

#include "core/base/result.h"
#include "core/interaction/section_edit.h"
#include "core/model/binding.h"
#include "core/values/values.h"
#include "ui/properties/followed.h"

#include <functional>
#include <optional>

class QLocale;

namespace fff::ui {

class Workbench;

/// How what is typed in the window is read: in the unit that is set, grams and degrees.
Reading windowReading(const QLocale &locale);
/// Of the document as it is, as they are listed.
QStringList valueNames(const Workbench &bench);

/// Makes the edit. What comes back says why it is none; empty: it was made.
QString tryEdit(Workbench &bench, SectionEdit edit);

/// Nothing: the field is of several now, or of none.
using PlaceNow = std::function<std::optional<DrivenPlace>()>;
/// What is there before the number can be bound, where that is not so by itself.
using Prepared = std::function<Result<Document>(const Document &)>;
/// bench: outlives the field
Followed followedAt(Workbench &bench, PlaceNow place, Prepared prepared = {});
/// Of the drawn section that is selected alone, or of which the selected one is an image.
PlaceNow selectedSectionPlace(const Workbench &bench, DrivenPlace::Of of, const char *field,
                              int index = 0);
/// What a value is made of.
Followed followedBy(Workbench &bench, ValueId value);

} // namespace fff::ui
