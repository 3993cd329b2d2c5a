#include "ui/actions/menu_table.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

/// So that lupdate knows whose texts these are: it does not look into macros of our own.
struct ActionSetTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ActionSet)
public:
    static std::span<const MenuRow> menus();
};

std::span<const MenuRow> ActionSetTexts::menus()
{
    static const MenuRow kMenus[] = {
        {QT_TR_NOOP("&File"),
         "file.new file.open @recent file.insert file.addToLibrary | file.save file.saveAs "
         "file.revert | file.export file.exportAgain | "
         "file.settings | file.close file.quit"},
        {QT_TR_NOOP("&Edit"),
         "edit.undo edit.redo | edit.cut edit.copy edit.paste edit.duplicate edit.delete | "
         ">mirrorCopy | "
         "edit.selectAll edit.selectConnected edit.selectParallel edit.selectSameStock "
         "edit.selectNext edit.selectPrevious | "
         "measure.ruler measure.dimension measure.keep measure.remove"},
        {QT_TR_NOOP("&View"),
         "view.front view.top view.right view.back view.bottom view.left view.iso "
         "view.faceSelection | view.fitAll view.fitSelection "
         "view.previous | view.perspective view.xray view.clip view.shadow | "
         "view.isolate view.hide view.showAll | "
         "@docks view.docks view.resetWindow | view.properties view.nextPane "
         "view.previousPane | "
         "view.fullScreen"},
        {QT_TR_NOOP("&Section"),
         "section.symmetry section.ground section.snap | section.pen >plane | section.redraw "
         "section.addHole section.removeHoles >shapes >points >drawing >marks | "
         "section.transform "
         "transform.inSpace "
         "transform.withChildren | section.putOn section.free section.makeOrthogonal "
         "section.snapNormal section.dropToGround section.lock | joint.flip joint.reset"},
        {QT_TR_NOOP("&Operation"),
         "operation.linear operation.revolve operation.blend operation.branch operation.grid "
         "operation.radial | operation.mirror operation.rotational operation.array "
         "operation.symmetric | "
         "operation.switch operation.moveUp operation.moveDown | "
         "operation.editSource operation.detach operation.leaveOut operation.bake"},
        {QT_TR_NOOP("&Checks"), "check.nextProblem check.previousProblem | check.showAssembly | "
                                "physics.addWeight physics.addPush physics.pull check.stress "
                                "physics.whereStrong"},
        {QT_TR_NOOP("F&abricate"), "fabricate.stocks | file.export"},
        {QT_TR_NOOP("&Help"), "help.firstSteps edit.find help.start | help.about"},
        {QT_TR_NOOP("&Mirror copy"),
         "edit.mirrorCopyX edit.mirrorCopyY edit.mirrorCopyZ edit.mirrorCopySection", "mirrorCopy"},
        {QT_TR_NOOP("Draw on a p&lane"),
         "section.planeGround section.planeFront section.planeSide section.planeParallel", "plane"},
        {QT_TR_NOOP("&Text and marks"), "section.mark | mark.engrave mark.score", "marks"},
        {QT_TR_NOOP("From S&VG"),
         "section.importSections section.importContour section.importHoles section.importMarks",
         "drawing"},
        {QT_TR_NOOP("Shape b&y numbers"),
         "section.addShape | section.addCircle section.addEllipse section.addRectangle "
         "section.addPolygon "
         "section.addStar section.addSlot | section.takeOffer",
         "shapes"},
        {QT_TR_NOOP("P&oints"),
         "point.insert point.delete | point.smooth point.symmetric point.corner", "points"},
        {"",
         "section.transform section.redraw section.addHole section.removeHoles >shapes >drawing "
         "section.mark | edit.cut "
         "edit.copy "
         "edit.paste edit.duplicate >mirrorCopy edit.delete | section.putOn section.free "
         "section.makeOrthogonal section.snapNormal section.lock | view.faceSelection "
         "view.fitSelection view.isolate view.hide | edit.selectConnected edit.selectParallel "
         "edit.selectSameStock",
         "context.section"},
        {"",
         "operation.editSource operation.detach operation.leaveOut | edit.copy edit.duplicate "
         ">mirrorCopy | view.faceSelection view.fitSelection view.isolate view.hide | "
         "edit.selectConnected edit.selectParallel edit.selectSameStock | operation.switch "
         "operation.bake",
         "context.made"},
        {"",
         "operation.editSource | edit.copy edit.duplicate edit.delete | operation.switch "
         "operation.moveUp operation.moveDown operation.bake | view.fitSelection view.isolate "
         "view.hide",
         "context.operation"},
        {"", "point.smooth point.symmetric point.corner | point.insert point.delete",
         "context.point"},
        {"",
         "point.insert | section.transform section.redraw section.addHole >shapes | edit.copy "
         "edit.duplicate edit.delete",
         "context.contour"},
        {"", "joint.flip joint.reset | view.fitSelection", "context.joint"},
        {"",
         "edit.paste | edit.selectAll view.showAll | >plane section.pen >shapes >drawing | "
         "measure.ruler measure.dimension | view.fitAll "
         "view.iso "
         "view.front view.top view.right view.previous | view.perspective view.xray view.clip",
         "context.empty"},
    };
    return kMenus;
}

} // namespace

std::span<const MenuRow> menuTable()
{
    return ActionSetTexts::menus();
}

} // namespace fff::ui
