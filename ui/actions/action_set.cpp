#include "ui/actions/action_set.h"

#include "ui/icon.h"
#include "ui/workbench.h"

#include <QMenu>
#include <QToolBar>

namespace fff::ui {

namespace {

// Texts for lupdate; tr() looks them up.
#define TEXT(text) QT_TRANSLATE_NOOP("fff::ui::ActionSet", text)

struct Row
{
    const char *id;
    const char *text;      // in menus
    const char *shortText; // in the tool bar
    const char *shortcuts; // separated by blanks
    const char *icon;
    const char *tip;        // the sentence of its tooltip
    bool isForView = false; // its shortcut needs the focus in the view
};

const Row kTable[] = {
    {"file.new", TEXT("&New"), TEXT("New"), "Ctrl+N", "new", TEXT("Start a new model")},
    {"file.open", TEXT("&Open…"), TEXT("Open"), "Ctrl+O", "open",
     TEXT("Open a model, also one of FlatFab")},
    {"file.save", TEXT("&Save"), TEXT("Save"), "Ctrl+S", "save", TEXT("Save the model")},
    {"file.saveAs", TEXT("Save &as…"), TEXT("Save as"), "Ctrl+Shift+S", "save_as",
     TEXT("Save the model under another name")},
    {"file.export", TEXT("&Export cutting files…"), TEXT("Export…"), "Ctrl+Shift+E", "export",
     TEXT("Write the parts to a file for the laser cutter")},
    {"file.quit", TEXT("&Quit"), TEXT("Quit"), "Ctrl+Q", "", TEXT("Close the program")},
    {"edit.undo", TEXT("&Undo"), TEXT("Undo"), "Ctrl+Z", "undo", TEXT("Take the last step back")},
    {"edit.redo", TEXT("&Redo"), TEXT("Redo"), "Ctrl+Shift+Z Ctrl+Y", "redo",
     TEXT("Do the step again that was taken back")},
    {"edit.delete", TEXT("&Delete"), TEXT("Delete"), "Del", "trash",
     TEXT("Delete the selected sections")},
    {"edit.selectAll", TEXT("Select &all"), TEXT("Select all"), "Ctrl+A", "",
     TEXT("Select all sections")},
    {"view.front", TEXT("&Front"), TEXT("Front"), "1", "view_front", TEXT("Look from the front"),
     true},
    {"view.top", TEXT("&Top"), TEXT("Top"), "2", "view_top", TEXT("Look from the top"), true},
    {"view.right", TEXT("&Right"), TEXT("Right"), "3", "view_right", TEXT("Look from the right"),
     true},
    {"view.back", TEXT("&Back"), TEXT("Back"), "4", "view_back", TEXT("Look from the back"), true},
    {"view.bottom", TEXT("Botto&m"), TEXT("Bottom"), "5", "view_bottom", TEXT("Look from below"),
     true},
    {"view.left", TEXT("&Left"), TEXT("Left"), "6", "view_left", TEXT("Look from the left"), true},
    {"view.iso", TEXT("Next &corner"), TEXT("Corner"), "0", "view_iso",
     TEXT("Look from the next corner"), true},
    {"view.faceSelection", TEXT("Face the &section"), TEXT("Face"), "N", "face_section",
     TEXT("Look straight at the selected section"), true},
    {"view.fitAll", TEXT("Fit &everything"), TEXT("Fit"), "Home", "fit",
     TEXT("Show the whole model"), true},
    {"view.fitSelection", TEXT("Fit se&lection"), TEXT("Fit selection"), "F", "fit_selection",
     TEXT("Show the selected sections as large as possible"), true},
    {"view.docks", TEXT("&Hide all docks"), TEXT("Hide docks"), "F9", "",
     TEXT("Hide or show the panels at the sides")},
    {"view.fullScreen", TEXT("F&ull screen"), TEXT("Full screen"), "F11", "",
     TEXT("Fill the screen with the window")},
    {"view.resetWindow", TEXT("Reset &window"), TEXT("Reset window"), "", "",
     TEXT("Put all panels back where they were at first")},
    {"help.about", TEXT("&About FlatFitFab"), TEXT("About"), "", "",
     TEXT("What this program is, and its version")},
};

const Row &rowOf(const QString &id)
{
    for (const Row &row : kTable) {
        if (id == QLatin1String(row.id))
            return row;
    }
    Q_UNREACHABLE();
}

QString tipOf(const QAction *action, const QString &sentence)
{
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    return keys.isEmpty() ? sentence : QStringLiteral("%1 (%2)").arg(sentence, keys);
}

} // namespace

ActionSet::ActionSet(Workbench &bench, QObject *parent) : QObject(parent), m_bench(bench)
{
    for (const Row &row : kTable) {
        auto *action = new QAction(tr(row.text), this);
        action->setObjectName(QLatin1String(row.id));
        action->setIconText(tr(row.shortText));
        if (*row.icon)
            action->setIcon(themedIcon(QLatin1String(row.icon)));
        QList<QKeySequence> shortcuts;
        for (const QString &keys :
             QString::fromLatin1(row.shortcuts).split(QLatin1Char(' '), Qt::SkipEmptyParts))
            shortcuts += QKeySequence(keys, QKeySequence::PortableText);
        action->setShortcuts(shortcuts);
        if (row.isForView)
            action->setShortcutContext(Qt::WidgetShortcut);
        action->setToolTip(tipOf(action, tr(row.tip)));
        const QString id = action->objectName();
        connect(action, &QAction::triggered, this, [this, id] { Q_EMIT triggered(id); });
        m_actions.insert(id, action);
    }
    action("view.docks")->setCheckable(true);
    action("view.fullScreen")->setCheckable(true);
    action("file.quit")->setMenuRole(QAction::QuitRole);
    action("help.about")->setMenuRole(QAction::AboutRole);

    connect(&bench, &Workbench::selectionChanged, this, &ActionSet::refresh);
    connect(&bench.session(), &Session::modelChanged, this, &ActionSet::refresh);
    connect(bench.session().history(), &QUndoStack::indexChanged, this, &ActionSet::refresh);
    refresh();
}

QAction *ActionSet::action(const char *id) const
{
    return m_actions.value(QLatin1String(id));
}

void ActionSet::fill(QMenu *menu, std::initializer_list<const char *> ids) const
{
    for (const char *id : ids) {
        if (*id)
            menu->addAction(action(id));
        else
            menu->addSeparator();
    }
}

void ActionSet::fill(QToolBar *bar, std::initializer_list<const char *> ids) const
{
    for (const char *id : ids) {
        if (*id)
            bar->addAction(action(id));
        else
            bar->addSeparator();
    }
}

void ActionSet::addViewShortcuts(QWidget *view) const
{
    for (const Row &row : kTable) {
        if (row.isForView)
            view->addAction(action(row.id));
    }
}

void ActionSet::setAble(const char *id, bool able, const QString &whyNot)
{
    QAction *a = action(id);
    a->setEnabled(able);
    a->setToolTip(tipOf(a, able ? tr(rowOf(a->objectName()).tip) : whyNot));
}

void ActionSet::refresh()
{
    const QUndoStack &history = *m_bench.session().history();
    const bool hasSections = m_bench.session().model().sectionCount() > 0;
    const bool hasSelection = !m_bench.interaction().selection().empty();

    setAble("edit.undo", history.canUndo(), tr("There is no step to take back"));
    setAble("edit.redo", history.canRedo(), tr("No step was taken back"));
    QAction *undo = action("edit.undo"), *redo = action("edit.redo");
    undo->setText(history.canUndo() ? tr("&Undo \u201c%1\u201d").arg(history.undoText())
                                    : tr("&Undo"));
    redo->setText(history.canRedo() ? tr("&Redo \u201c%1\u201d").arg(history.redoText())
                                    : tr("&Redo"));
    undo->setIconText(tr("Undo"));
    redo->setIconText(tr("Redo"));
    if (history.canUndo())
        undo->setToolTip(tipOf(undo, tr("Undo \u201c%1\u201d").arg(history.undoText())));
    if (history.canRedo())
        redo->setToolTip(tipOf(redo, tr("Redo \u201c%1\u201d").arg(history.redoText())));

    const QString nothingThere = tr("There is no section yet");
    const QString nothingSelected = tr("No section is selected");
    setAble("file.export", hasSections, nothingThere);
    setAble("edit.selectAll", hasSections, nothingThere);
    setAble("edit.delete", hasSelection, nothingSelected);
    setAble("view.faceSelection", hasSelection, nothingSelected);
    setAble("view.fitSelection", hasSelection, nothingSelected);
}

} // namespace fff::ui
