#include "core/session/session_host.h"

#include "core/session/operation_text.h"

#include <QCoreApplication>

namespace fff {

namespace {

struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(fff::SessionHost)
};

/// With places for the names of its two sections.
QString kindStep(JointKind kind)
{
    switch (kind) {
    case JointKind::CrossLap:
        //: %1 and %2 are the names of two sections
        return Texts::tr("%1 · %2: kind → cross lap");
    case JointKind::ExtendedCrossLap:
        //: %1 and %2 are the names of two sections
        return Texts::tr("%1 · %2: kind → extended cross lap");
    case JointKind::Mortise:
        //: %1 and %2 are the names of two sections
        return Texts::tr("%1 · %2: kind → mortise");
    case JointKind::Tabs:
        //: %1 and %2 are the names of two sections
        return Texts::tr("%1 · %2: kind → tabs");
    case JointKind::None:
        break;
    }
    //: %1 and %2 are the names of two sections
    return Texts::tr("%1 · %2: kind → none");
}

/// "Back plates: Count 9 → 13", "Back plates: Along → Body".
QString changeText(const QString &name, const Step::Change &change)
{
    const OperationKind *kind = operationKind(change.kind);
    const ParameterSpec *spec = kind ? kind->parameter(change.key) : nullptr;
    const InputSpec *input = kind ? kind->input(change.key) : nullptr;
    if (input && change.after && std::holds_alternative<std::string>(*change.after))
        //: %1 is the name of an operation, %2 of what it works on ("Along"), %3 of a section
        return Texts::tr("%1: %2 → %3")
            .arg(name, operationText(input->label),
                 QString::fromStdString(std::get<std::string>(*change.after)));
    if (!spec)
        //: %1 is the name of an operation
        return Texts::tr("Change %1").arg(name);
    //: %1 is the name of an operation, %2 of a number ("Count"), %3 and %4 what it was and is
    return Texts::tr("%1: %2 %3 → %4")
        .arg(name, operationText(spec->label), valueText(*spec, change.before),
             valueText(*spec, change.after));
}

} // namespace

SessionHost::SessionHost(Session &session, QObject *parent) : QObject(parent), m_session(session) {}

void SessionHost::attach(Interaction &interaction)
{
    connect(&m_session, &Session::modelChanged, this,
            [&interaction] { interaction.modelChanged(); });
    connect(&m_session, &Session::committedChanged, this,
            [&interaction] { interaction.modelChanged(); });
    connect(&m_session, &Session::replaced, this, [&interaction] {
        interaction.select({});
        interaction.forgetViews();
    });
    interaction.modelChanged();
}

const Model &SessionHost::model() const
{
    return m_session.committed();
}

void SessionHost::preview(Document document)
{
    m_session.preview(std::move(document));
}

void SessionHost::cancelPreview()
{
    m_session.cancelPreview();
}

void SessionHost::commit(const Step &step, Document document)
{
    m_session.commit(undoText(step), std::move(document), step.merges);
}

void SessionHost::chooseProblem(int number)
{
    Q_EMIT problemChosen(number);
}

void SessionHost::chooseParameter(OperationId operation, const std::string &key)
{
    Q_EMIT parameterChosen(operation, QString::fromStdString(key));
}

QString SessionHost::undoText(const Step &step)
{
    const int count = static_cast<int>(step.names.size());
    const QString name = count > 0 ? QString::fromStdString(step.names.front()) : QString();
    const QString other = count > 1 ? QString::fromStdString(step.names[1]) : QString();
    switch (step.kind) {
    case Step::Kind::DrawSection:
        //: %1 is the name of a section
        return tr("Draw %1").arg(name);
    case Step::Kind::RedrawSection:
        //: %1 is the name of a section
        return tr("Redraw %1").arg(name);
    case Step::Kind::AddHole:
        //: %1 is the name of a section
        return tr("Draw a hole in %1").arg(name);
    case Step::Kind::DropToGround:
        return tr("Drop to the ground");
    case Step::Kind::StretchToGround:
        //: %1 is the name of a section
        return count == 1 ? tr("Stretch %1 to the ground").arg(name)
                          : tr("Stretch %n sections to the ground", nullptr, count);
    case Step::Kind::MovePoints:
        //: %1 is the name of a section
        return step.count == 1 ? tr("Move point of %1").arg(name)
                               : tr("Move %n points of %1", nullptr, step.count).arg(name);
    case Step::Kind::MoveHandle:
        //: %1 is the name of a section
        return tr("Move handle of %1").arg(name);
    case Step::Kind::BendContour:
        //: %1 is the name of a section
        return tr("Bend contour of %1").arg(name);
    case Step::Kind::AddPoint:
        //: %1 is the name of a section
        return tr("Add point to %1").arg(name);
    case Step::Kind::DeletePoints:
        //: %1 is the name of a section
        return step.count == 1 ? tr("Delete point of %1").arg(name)
                               : tr("Delete %n points of %1", nullptr, step.count).arg(name);
    case Step::Kind::ChangePoints:
        //: %1 is the name of a section
        return step.count == 1 ? tr("Change point of %1").arg(name)
                               : tr("Change %n points of %1", nullptr, step.count).arg(name);
    case Step::Kind::ChangeFigure:
        //: %1 is the name of a section
        return tr("Change shape of %1").arg(name);
    case Step::Kind::RemoveHoles:
        //: %1 is the name of a section
        return count == 1 ? tr("Remove holes of %1").arg(name)
                          : tr("Remove holes of %n sections", nullptr, count);
    // One section is named, so that the texts with a number need no singular.
    case Step::Kind::DeleteSections:
        //: %1 is the name of a section
        return count == 1 ? tr("Delete %1").arg(name) : tr("Delete %n sections", nullptr, count);
    case Step::Kind::RenameSection:
    case Step::Kind::RenameOperation:
        //: %1 is the name of a section or an operation
        return tr("Rename %1").arg(name);
    case Step::Kind::MoveSection:
        //: %1 is the name of a section
        return count == 1 ? tr("Move %1").arg(name) : tr("Move %n sections", nullptr, count);
    case Step::Kind::TurnSection:
        //: %1 is the name of a section
        return count == 1 ? tr("Turn %1").arg(name) : tr("Turn %n sections", nullptr, count);
    case Step::Kind::ScaleSection:
        //: %1 is the name of a section
        return count == 1 ? tr("Scale %1").arg(name) : tr("Scale %n sections", nullptr, count);
    case Step::Kind::CopySections:
        //: %1 is the name of a section
        return count == 1 ? tr("Copy %1").arg(name) : tr("Copy %n sections", nullptr, count);
    case Step::Kind::MirrorSections:
        //: %1 is the name of a section
        return count == 1 ? tr("Mirror a copy of %1").arg(name)
                          : tr("Mirror copies of %n sections", nullptr, count);
    case Step::Kind::PasteSections:
        //: %1 is the name of a section
        return count == 1 ? tr("Paste %1").arg(name) : tr("Paste %n sections", nullptr, count);
    case Step::Kind::CutSections:
        //: %1 is the name of a section
        return count == 1 ? tr("Cut %1").arg(name) : tr("Cut %n sections", nullptr, count);
    case Step::Kind::ImportDrawing:
        //: %1 is the name of a file
        return tr("Import %1").arg(name);
    case Step::Kind::AddMark:
        //: %1 is the name of a section
        return tr("Mark %1").arg(name);
    case Step::Kind::ChangeMark:
        //: %1 is the name of a section
        return tr("Change mark of %1").arg(name);
    case Step::Kind::DeleteMark:
        //: %1 is the name of a section
        return tr("Delete mark of %1").arg(name);
    case Step::Kind::AddDimension:
        return tr("Keep dimension");
    case Step::Kind::DeleteDimension:
        return tr("Delete dimension");
    case Step::Kind::ScaleModel:
        //: %1 is a number of percent
        return tr("Scale the model to %1 %").arg(step.count);
    case Step::Kind::SetNumber:
        //: %1 is the name of a number
        return tr("Set %1").arg(name);
    case Step::Kind::DeleteNumber:
        //: %1 is the name of a number
        return tr("Delete %1", "a number").arg(name);
    case Step::Kind::InsertModel:
        //: %1 is the name of a file
        return tr("Insert %1").arg(name);
    case Step::Kind::MakeOrthogonal:
        //: %1 is the name of a section
        return count == 1 ? tr("Make %1 orthogonal").arg(name)
                          : tr("Make %n sections orthogonal", nullptr, count);
    case Step::Kind::AlignSection:
        //: %1 is the name of a section
        return count == 1 ? tr("Align %1 to an axis").arg(name)
                          : tr("Align %n sections to an axis", nullptr, count);
    case Step::Kind::PutOn:
        //: %1 is the name of a section
        return tr("Put %1 on another section").arg(name);
    case Step::Kind::FreeSection:
        //: %1 is the name of a section
        return count == 1 ? tr("Free %1").arg(name) : tr("Free %n sections", nullptr, count);
    case Step::Kind::HoldSection:
        //: %1 is the name of a section
        return count == 1 ? tr("Hold %1").arg(name) : tr("Hold %n sections", nullptr, count);
    case Step::Kind::LockSection:
        //: %1 is the name of a section
        return count == 1 ? tr("Lock %1").arg(name) : tr("Lock %n sections", nullptr, count);
    case Step::Kind::UnlockSection:
        //: %1 is the name of a section
        return count == 1 ? tr("Unlock %1").arg(name) : tr("Unlock %n sections", nullptr, count);
    case Step::Kind::MoveToSection:
        //: %1 is the name of a section, %2 of the one that it comes to
        return count == 2 ? tr("Move %1 to %2").arg(name, other)
                          //: %1 is the name of a section
                          : tr("Move %n sections to %1", nullptr, count - 1)
                                .arg(QString::fromStdString(step.names.back()));
    case Step::Kind::SetStock:
        //: %1 is the name of a section
        return count == 1 ? tr("Change stock of %1").arg(name)
                          : tr("Change stock of %n sections", nullptr, count);
    case Step::Kind::EditStock:
        //: %1 is the name of a stock
        return tr("Edit %1").arg(name);
    case Step::Kind::MakeAssemblable:
        return tr("Make assemblable");
    case Step::Kind::SetJointKind:
        return kindStep(step.joint).arg(name, other);
    case Step::Kind::FlipSlits:
        //: %1 and %2 are the names of two sections
        return tr("%1 · %2: flip the slits").arg(name, other);
    case Step::Kind::MoveMeetingPoint:
        //: %1 and %2 are the names of two sections, %3 a number
        return tr("%1 · %2: meeting point → %3\u202f%")
            .arg(name, other, QString::number(step.count));
    case Step::Kind::JoinSections:
        //: %1 and %2 are the names of two sections
        return tr("Join %1 and %2").arg(name, other);
    case Step::Kind::ResetJoint:
        //: %1 and %2 are the names of two sections
        return tr("%1 · %2: reset to automatic").arg(name, other);
    case Step::Kind::TrimSection:
        //: %1 and %2 are the names of two sections
        return tr("Trim %1 to %2").arg(name, other);
    case Step::Kind::AddOperation:
        //: %1 is the name of an operation
        return tr("Add %1").arg(name);
    case Step::Kind::ChangeOperation:
        return step.change ? changeText(name, *step.change)
                           //: %1 is the name of an operation
                           : tr("Change %1").arg(name);
    case Step::Kind::SwitchOnOperation:
        //: %1 is the name of an operation
        return tr("Switch %1 on").arg(name);
    case Step::Kind::SwitchOffOperation:
        //: %1 is the name of an operation
        return tr("Switch %1 off").arg(name);
    case Step::Kind::MoveOperation:
        //: %1 is the name of an operation
        return tr("Change the order of %1").arg(name);
    case Step::Kind::DeleteOperation:
        //: %1 is the name of an operation
        return tr("Delete %1").arg(name);
    case Step::Kind::BakeOperation:
        //: %1 is the name of an operation
        return tr("Bake %1").arg(name);
    case Step::Kind::MakeSymmetric:
        return tr("Make symmetric");
    case Step::Kind::HideInstance:
        //: %1 is the name of a section that an operation made
        return count == 1 ? tr("Leave out %1").arg(name)
                          : tr("Leave out %n sections", nullptr, count);
    case Step::Kind::ShowInstance:
        return tr("Make a left out section again");
    case Step::Kind::DetachInstance:
        //: %1 is the name of a section that an operation made
        return tr("Detach %1").arg(name);
    }
    return {};
}

} // namespace fff
