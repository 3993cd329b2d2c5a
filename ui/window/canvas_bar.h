// A bar over the view for the numbers of the tool in the hand: where the next point goes, how far
// away a plane is, how far sections are moved; and for the commands that go with it. For points it
// opens with the first key of a number; all else is there as long as the tool waits.
#pragma once

#include <QFrame> // first: moc stumbles over some standard headers

#include "core/interaction/tool.h"

#include <QTimer>

#include <string_view>
#include <vector>

class QGridLayout;
class QLabel;
class QToolButton;

namespace fff::ui {

class ActionSet;
class NumberEdit;
class Workbench;

/// What is typed is shown in the view at once, what makes all of it larger or smaller when the
/// number is whole. Enter does it, Tab goes to the next field, Esc
/// closes the bar and leaves all as it was.
class CanvasBar : public QFrame
{
    Q_OBJECT
public:
    /// At the lower edge of the view.
    CanvasBar(Workbench &bench, const ActionSet &actions, QWidget *view);

    /// Opens it and puts the first key there: "@" goes to the distance from the last point.
    void begin(const QString &text);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    bool focusNextPrevChild(bool next) override;
    void paintEvent(QPaintEvent *event) override;

private:
    struct Field
    {
        ToolNumber::Kind kind;
        QLabel *label;
        NumberEdit *edit;
        bool isWanted = false; // the tool has this number now
    };

    void addField(ToolNumber::Kind kind, NumberEdit *edit, const QString &name,
                  const char *objectName);
    Field *field(ToolNumber::Kind kind);
    void refresh();
    void take(ToolNumber::Kind kind, double shown);
    void takeTyped();
    void accept();
    void close();
    void follow(QWidget *focus);
    void place();
    void arrange(int fieldsInRow, int cellsInRow);
    void showCommands();
    QWidget *cellOf(const CommandGroup &group, std::string_view main);
    QToolButton *buttonOf(std::string_view command, bool isMain, QWidget *parent);

    Workbench &m_bench;
    const ActionSet &m_actions;
    QWidget *m_buttons = nullptr;
    std::vector<CommandGroup> m_commands; // that have buttons
    /// A button each, or where there are several groups of them a group.
    std::vector<QWidget *> m_commandCells;
    QGridLayout *m_grid = nullptr, *m_buttonGrid = nullptr;
    std::vector<Field> m_fields;
    QTimer m_typing;       // after the last key in the field of a wanted length
    bool m_isOpen = false; // something is typed, or was
};

} // namespace fff::ui
