// A small model whose numbers are made of values, and short words for what tests do with it.
#pragma once

#include "core/geometry/figure.h"
#include "core/model/bindings.h"
#include "core/model/figures.h"
#include "core/model/lettering.h"
#include "core/model/load_edits.h"
#include "core/model/marks.h"
#include "core/operations/driven.h"
#include "tests/core/operations/operation_models.h"

#include <string>

namespace fff::test {

inline Document withValue(Document document, const char *name, const char *typed,
                          ValueKind kind = ValueKind::Length)
{
    Value value;
    value.name = name;
    value.kind = kind;
    value.typed = typed;
    return addValue(std::move(document), std::move(value)).value();
}

/// A board with a round hole, words and a weight, and one across it.
inline Document shelf()
{
    Document document = newDocument();
    Figure hole = newFigure(*figureKind("circle"));
    hole.centre = {50.0, 20.0};
    hole.numbers = {10.0};
    const Contour board = polygonContour(rectangleAt(0, 0, 200, 40));
    const SectionId a =
        add(document, "Board", shapeOf(board, {contourOf(hole).value()}), frontFrame());
    document = addFigure(std::move(document), a, hole).value();
    const Parent parent{a, {100, 20}, {100, 40}, false};
    add(document, "Rib", shapeOf(polygonContour(rectangleAt(-30, 0, 60, 60))),
        sideFrame({100, 0, 0}), parent);
    document = addMark(std::move(document), a, letteredMark({"A", 8.0, {150, 20}, 0.0}, {}).value())
                   .value();
    Load load;
    load.section = a;
    load.position = {20, 30};
    document = addLoad(std::move(document), load).value();
    return document;
}

inline DrivenPlace at(const Document &document, const std::string &key)
{
    const auto place = placeOfKey(document, key);
    return place ? *place : DrivenPlace{.field = "none: " + key};
}

inline std::string key(const char *of, std::int64_t id, const char *field)
{
    return std::string(of) + '/' + std::to_string(id) + '/' + field;
}

inline std::string stockKey(const Document &document, const char *field)
{
    return key("stock", document.currentStock.value, field);
}

inline double numberAt(const Document &document, const std::string &key)
{
    return drivenNumber(document, at(document, key)).value().worth.number;
}

inline Document madeOf(Document document, const std::string &key, const char *typed)
{
    auto next = bound(document, at(document, key), typed);
    return next ? *std::move(next) : document;
}

inline ValueId idOf(const Document &document, const char *name)
{
    return document.values.find(std::string_view(name))->id;
}

inline Document typed(Document document, const char *name, const char *text)
{
    const ValueId id = idOf(document, name);
    return evaluate(typeValue(std::move(document), id, text, {}).value()).document;
}

} // namespace fff::test
