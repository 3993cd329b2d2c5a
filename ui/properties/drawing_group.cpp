#include "ui/properties/drawing_group.h"

#include "ui/properties/number_edit.h"
#include "ui/settings/settings.h"

#include <QCheckBox>

namespace fff::ui {

namespace {

PropertyRow *switchRow(const QString &name, const char *objectName, const QString &tip,
                       DrawingSwitch what, QWidget *parent)
{
    auto *box = new QCheckBox(parent);
    QObject::connect(box, &QCheckBox::toggled, box,
                     [what](bool on) { settings().setOn(what, on); });
    auto *row = new EditorRow(
        name, objectName, box, [box, what] { box->setChecked(settings().isOn(what)); }, parent);
    row->setToolTip(tip);
    return row;
}

PropertyRow *numberRow(const QString &name, const char *objectName, const QString &tip,
                       const NumberEdit::Range &range, const QString &unit, int (*read)(),
                       void (*write)(int), QWidget *parent)
{
    auto *edit = new NumberEdit(range, unit, parent);
    QObject::connect(edit, &NumberEdit::numberEdited, edit,
                     [write](double value) { write(static_cast<int>(value)); });
    auto *row = new EditorRow(
        name, objectName, edit, [edit, read] { edit->setNumber(read()); }, parent);
    row->setToolTip(tip);
    return row;
}

} // namespace

DrawingGroup::DrawingGroup(QWidget *parent) : PropertyGroup(tr("Drawing"), parent)
{
    addRow(switchRow(tr("Local symmetry"), "localSymmetry",
                     tr("Mirror a contour across its slit when it is drawn on one side of it. "
                        "Shift does the opposite while you draw."),
                     DrawingSwitch::Symmetry, this));
    addRow(switchRow(tr("Mirror the first"), "firstSymmetry",
                     tr("Mirror the first section too, across the vertical through its start"),
                     DrawingSwitch::FirstSymmetry, this));
    addRow(switchRow(tr("Cut at ground"), "cutAtGround",
                     tr("Cut flat at the ground: leave out what is drawn below it"),
                     DrawingSwitch::Ground, this));
    addRow(switchRow(tr("Snap"), "snap", tr("Snap to points, alignment lines, ground and grid"),
                     DrawingSwitch::Snap, this));
    addRow(numberRow(
        tr("View turns by"), "turnAngle",
        tr("At 90° you look straight at the new plane; with less, the section that you started on "
           "stays visible"),
        {Settings::kMinTurnAngle, Settings::kMaxTurnAngle, 1.0, 0, 0}, tr("°"),
        [] { return settings().turnAngle(); }, [](int angle) { settings().setTurnAngle(angle); },
        this));
    addRow(numberRow(
        tr("Turning time"), "turnTime",
        tr("How long the view takes to turn to the plane of a new section"),
        {0.0, Settings::kMaxTurnTime, 50.0, 0, 0}, tr("ms"), [] { return settings().turnTime(); },
        [](int time) { settings().setTurnTime(time); }, this));
    connect(&settings(), &Settings::drawingChanged, this, &DrawingGroup::refresh);
    connect(&settings(), &Settings::viewChanged, this, &DrawingGroup::refresh);
    refresh();
}

void DrawingGroup::addRow(PropertyRow *row)
{
    add(row);
    m_all.push_back(row);
}

void DrawingGroup::refresh()
{
    for (PropertyRow *row : m_all)
        row->refresh();
}

} // namespace fff::ui
