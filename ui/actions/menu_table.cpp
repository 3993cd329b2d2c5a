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
         "file.new file.open @recent file.insert section.importSections template.addMesh | "
         "file.save file.saveAs "
         "| fabricate.stocks file.export | file.settings | file.close file.quit"},
        {QT_TR_NOOP("&Edit"), "edit.undo edit.redo | edit.cut edit.copy edit.paste edit.duplicate "
                              "edit.mirror edit.delete | edit.selectAll"},
        {QT_TR_NOOP("&View"),
         ">faces view.faceSelection view.fitAll | view.perspective view.xray "
         "view.clip view.skin | view.isolate view.showAll | >panels view.fullScreen"},
        {QT_TR_NOOP("&Section"),
         "section.symmetry section.ground section.snap | section.pen >plane section.addShape "
         "section.mark | section.transform"},
        {QT_TR_NOOP("&Operation"),
         "operation.linear operation.revolve operation.blend operation.branch operation.grid "
         "operation.radial | operation.rotational operation.array"},
        {QT_TR_NOOP("&Checks"), "check.nextProblem check.showAssembly | physics.addWeight "
                                "check.stress"},
        {QT_TR_NOOP("&Help"), "help.tour help.firstSteps edit.find help.start | help.about"},

        {QT_TR_NOOP("&Look from"),
         "view.front view.top view.right view.back view.bottom view.left view.iso", "faces"},
        {QT_TR_NOOP("Pa&nels"), "@docks | view.docks view.resetWindow", "panels"},
        {QT_TR_NOOP("Draw on a p&lane"),
         "section.planeGround section.planeFront section.planeSide section.planeParallel", "plane"},
        {QT_TR_NOOP("Dra&w on it"),
         "section.addShape section.mark section.removeHoles | section.importContour "
         "section.importHoles section.importMarks",
         "onIt"},
        {QT_TR_NOOP("Arran&ge"),
         "section.putOn section.free section.makeOrthogonal section.snapNormal "
         "section.dropToGround",
         "arrange"},
        {QT_TR_NOOP("&Select"),
         "edit.selectConnected edit.selectParallel edit.selectSameStock | edit.selectAll",
         "select"},

        // What has its place on a bar, a page, a key or a right click.
        {QT_TR_NOOP("&File"),
         "file.revert file.addToLibrary file.exportAgain file.shortcuts fabricate.coupon "
         "sheets.unpinAll",
         kSearchedMenu},
        {QT_TR_NOOP("&Edit"),
         "edit.selectConnected edit.selectParallel edit.selectSameStock edit.selectNext "
         "edit.selectPrevious measure.ruler measure.dimension measure.keep measure.remove mirror.x "
         "mirror.y "
         "mirror.z mirror.section mirror.copy mirror.always mirror.once mirror.apply "
         "mirror.cancel "
         "edit.mirrorCopyX edit.mirrorCopyY edit.mirrorCopyZ edit.mirrorCopySection",
         kSearchedMenu},
        {QT_TR_NOOP("&View"),
         "view.fitSelection view.previous view.shadow view.hide view.properties view.values "
         "view.newValue value.handOn view.nextPane view.previousPane",
         kSearchedMenu},
        {QT_TR_NOOP("&Section"),
         "section.addCircle section.addEllipse section.addRectangle section.addPolygon "
         "section.addStar section.addSlot section.redraw section.addHole section.takeOffer "
         "section.takeGuide "
         "mark.engrave "
         "mark.score "
         "section.importContour section.importHoles section.importMarks section.removeHoles "
         "section.dropToGround section.putOn section.free section.makeOrthogonal "
         "section.snapNormal section.lock "
         "transform.inSpace transform.withChildren point.insert point.delete point.smooth "
         "point.symmetric point.corner joint.flip joint.reset "
         "template.transform template.sizeByLine",
         kSearchedMenu},
        {QT_TR_NOOP("&Operation"),
         "operation.slices operation.mirror operation.symmetric operation.switch operation.moveUp "
         "operation.moveDown operation.editSource operation.detach operation.leaveOut "
         "operation.bake",
         kSearchedMenu},
        {QT_TR_NOOP("&Checks"),
         "check.previousProblem physics.whereStrong physics.addPush physics.pull", kSearchedMenu},
        {QT_TR_NOOP("&Help"), "help.here @help", kSearchedMenu},

        {"",
         "section.transform section.redraw section.addHole >onIt | edit.copy edit.duplicate "
         "edit.mirror edit.delete | >arrange >select section.lock view.hide",
         "context.section"},
        {"",
         "operation.editSource operation.detach operation.leaveOut | edit.copy edit.duplicate "
         "edit.mirror | >select view.faceSelection view.isolate view.hide | operation.switch "
         "operation.bake",
         "context.made"},
        {"",
         "@rename operation.editSource | edit.copy edit.duplicate edit.delete | operation.switch "
         "operation.moveUp operation.moveDown operation.bake | view.fitSelection view.isolate "
         "view.hide",
         "context.operation"},
        {"",
         "@rename | section.transform edit.copy edit.duplicate edit.mirror edit.delete | >arrange "
         ">select section.lock view.hide view.isolate view.fitSelection",
         "context.outline"},
        {"", "point.smooth point.symmetric point.corner | point.insert point.delete",
         "context.point"},
        {"",
         "point.insert | section.transform section.redraw section.addHole >onIt | edit.copy "
         "edit.duplicate edit.delete",
         "context.contour"},
        {"", "joint.flip joint.reset | view.fitSelection", "context.joint"},
        {"",
         "edit.paste edit.selectAll view.showAll | >plane section.pen section.addShape "
         "section.importSections | measure.ruler | view.fitAll >faces view.xray view.clip",
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
