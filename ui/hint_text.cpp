#include "ui/hint_text.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

struct HintText
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::HintText)
};

} // namespace

QString hintSentence(const Hint &hint, const QString &undoKeys)
{
    const QString name =
        QStringLiteral("<b>%1</b>").arg(QString::fromStdString(hint.section).toHtmlEscaped());
    switch (hint.kind) {
    case Hint::Kind::DrawFirstSection:
        return HintText::tr("Draw the first section: press, draw its shape in one go, release.");
    case Hint::Kind::TurnView:
        return HintText::tr("Drag to turn the view; middle drag moves it, the wheel zooms.");
    case Hint::Kind::DragOutOfSection:
        return HintText::tr("Drag out of %1 to draw a section across it; click to select it.")
            .arg(name);
    case Hint::Kind::LeaveSection:
        return HintText::tr(
                   "Drag on to leave %1; the slit ends at its edge. <kbd>Esc</kbd> cancels.")
            .arg(name);
    case Hint::Kind::Turning:
        return HintText::tr("Turning to the new plane; move on when it stops.");
    case Hint::Kind::LeaveDeadZone:
        return HintText::tr(
            "Leave the grey zone where the contour shall begin. Release here cancels.");
    case Hint::Kind::DrawContour:
        return HintText::tr("Draw the contour, release to close it. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::ReleaseToMake:
        return HintText::tr("<b>Release</b> to make the section. <kbd>Esc</kbd> cancels.");
    case Hint::Kind::Orbiting:
        return HintText::tr("Move to turn the view, release to stop.");
    case Hint::Kind::Panning:
        return HintText::tr("Move to shift the view, release to stop.");
    case Hint::Kind::NeverLeft:
        return HintText::tr(
                   "Nothing drawn: the slit never left %1. Start inside and drag across its edge.")
            .arg(name);
    case Hint::Kind::TooShort:
        return HintText::tr("Nothing drawn: the line is too short to enclose anything.");
    case Hint::Kind::CrossesItself:
        return undoKeys.isEmpty()
                   ? HintText::tr("The contour crosses itself; the largest loop was kept.")
                   : HintText::tr("The contour crosses itself; the largest loop was kept. "
                                  "<kbd>%1</kbd> undoes it.")
                         .arg(undoKeys.toHtmlEscaped());
    case Hint::Kind::Failed:
        return HintText::tr(
            "Nothing drawn: no section can be made of this line. Draw it as one open loop.");
    }
    return {};
}

} // namespace fff::ui
