// The model and its steps for the page's own code: JSON (resources/steps_page reads it).
#pragma once

#include "core/interaction/camera.h"
#include "core/session/assembly_steps.h"

#include <QString>

#include <map>
#include <string>

namespace fff::ui {

/// {texts, view, looks, shapes, parts, steps}; lengths in mm, world coordinates.
///
///   texts   what the page says, by key
///   view    towards the eye, unit: from where it is seen at first
///   looks   of the stocks: face and side as "#rrggbb", alpha
///   shapes  {look, thickness, unit, points, triangles, isWide}: base64 of 16-bit x, y in units of
///           `unit` mm (0.01, or what makes larger ones fit) about the middle of the shape's box,
///           and of triangles' corners, of 16 bits or, isWide, 32. Parts that are equal share one.
///   parts   {number, shape, place, numberAt, engraved}: the middle, x and y axes in the world;
///           where the number is engraved, from the middle, if there is room for it; polylines of
///           `counts` points each in the shape's units, on the upper face
///   steps   {title, text, parts, way}: indices of parts, and corners as Playback has them
///
/// Nothing in it ends the script element that it stands in. Same bytes for same input.
std::string stepsPageData(const AssemblySteps &steps, const std::map<std::string, QString> &texts,
                          const Camera &looking);

/// "Slide Rib 3 down into Body."
QString stepSentence(const AssemblySteps &steps, int step);

} // namespace fff::ui
