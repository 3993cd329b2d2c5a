// Small models and texts that the tests of core/io share.
#pragma once

#include "core/io/error_text.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"

#include <QtCore/QtGlobal>
#include <cmath>
#include <numbers>
#include <string>

namespace fff::test {

/// A plate with one curved side and a round hole of four segments.
inline ShapePointer plateWithHole()
{
    std::vector<Vec2> contour =
        Contour::fromPolygon({{0, 0}, {80, 0}, {80, 50.5}, {0, 50.5}}).value().points();
    contour[7] = {60, 70.25};
    contour[8] = {20, 70.25};
    const double r = 8.0;
    const double h =
        4.0 / 3.0 * std::tan(std::numbers::pi / 8.0) * r; // handles of a quarter circle
    std::vector<Vec2> hole = {{r, 0},  {r, -h}, {h, -r}, {0, -r}, {-h, -r}, {-r, -h},
                              {-r, 0}, {-r, h}, {-h, r}, {0, r},  {h, r},   {r, h}};
    for (Vec2 &p : hole)
        p += Vec2(40, 25);
    return Shape::make(Contour::fromPoints(contour).value(), {Contour::fromPoints(hole).value()})
        .value();
}

inline ShapePointer rib()
{
    return Shape::make(Contour::fromPolygon({{-15, 0}, {15, 0}, {0.1, 1.0 / 3.0 + 40}}).value())
        .value();
}

/// Two sections, the second drawn on the first; a hole, a parent, a weight, two stocks, one of them
/// not rated.
inline Document twoSections()
{
    Document document = newDocument();
    NewSection back;
    back.name = "Rückwand";
    back.shape = plateWithHole();
    back.frame.origin = {0, 83.82, 0};
    document = addSection(document, back).value();

    Stock card;
    card.name = "Grey \"card\" \\ 2 mm";
    card.thickness = 2.0;
    card.density = 640.5;
    card.clearance = -0.05;
    document = addStock(document, card).value();

    NewSection second;
    second.name = "肋骨 – ребро";
    second.shape = rib();
    second.frame = makeFrame({40, 110, 0.5}, {0, 0.28, 0.96}, {0, -0.96, 0.28}).value();
    second.parent = Parent{document.sections.front()->id, {40, 20}, {40, 65.3125}};
    document = addSection(document, second).value();

    Load weight;
    weight.section = document.sections.back()->id;
    weight.position = {0.1 + 0.2, -5e-7};
    weight.mass = 0.35;
    return addLoad(document, weight).value();
}

/// FlatFab's text of `count` square sections with a side of 2 units, the first with a hole.
inline std::string flatfabSquares(int count = 2, const std::string &headerWord = "PlaneSketch")
{
    std::string text = "HeaderParameters 1\n" + headerWord + " " + std::to_string(count) + "\n";
    for (int i = 0; i < count; ++i) {
        text += "P " + std::to_string(i) + " 3 0\nT 1 0 0\nN 0 0 1\nB 0 1 0\n";
        text += i == 0 ? "BoundaryCurves 2\n" : "BoundaryCurves 1\n";
        text += "SketchPoints 2\n0 0\n0.5 0.25\nBezierPoints 13\n"
                "-1 -1\n-0.5 -1\n0.5 -1\n1 -1\n1 -0.5\n1 0.5\n1 1\n0.5 1\n-0.5 1\n-1 1\n"
                "-1 0.5\n-1 -0.5\n-1 -1\n";
        if (i == 0)
            text += "SketchPoints 0\nBezierPoints 10\n"
                    "0 0\n0.1 0\n0.2 0\n0.4 0\n0.4 0.1\n0.4 0.2\n0.4 0.4\n0.2 0.2\n0.1 0.1\n0 0\n";
    }
    return text;
}

/// Every `from` replaced.
inline std::string replaced(std::string text, const std::string &from, const std::string &to)
{
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// The first `from` replaced; there must be one.
inline std::string replacedOnce(std::string text, const std::string &from, const std::string &to)
{
    const std::size_t at = text.find(from);
    if (at == std::string::npos)
        qFatal("the text has no \"%s\"", from.c_str());
    return text.replace(at, from.size(), to);
}

/// What is wrong with how an error reads; empty when it is one line that begins with its place and
/// goes on with a sentence.
inline QString unclear(const Error &error)
{
    const QString text = io::errorText(error), sentence = io::errorSentence(error);
    for (const QChar c : text) {
        if (c.category() == QChar::Other_Control || c.category() == QChar::Separator_Line)
            return QStringLiteral("not one line: ") + text;
    }
    if (error.place.empty() || !text.startsWith(QString::fromStdString(error.place)))
        return QStringLiteral("no place: ") + text;
    if (sentence.trimmed().size() < 10 || sentence.size() > 300)
        return QStringLiteral("no sentence: ") + text;
    return {};
}

} // namespace fff::test
