#include "ui/dialogs/cut_rows.h"

#include "core/fabrication/fit_coupon.h"
#include "ui/base/lengths.h"
#include "ui/properties/number_edit.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace fff::ui {

namespace {

struct CutRowsTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::CutRows)
};

constexpr NumberEdit::Range kTabCount{0.0, kMostTabs, 1.0, 0, 0};
constexpr LengthEdit::Range kTabWidthRange{kLeastTabWidth, kMostTabWidth, 0.1, 1, 2},
    kLeadRange{0.0, kMostLead, 0.5, 1, 2};

struct FinishAccess
{
    std::function<CutFinish()> read;
    std::function<void(const CutFinish &)> write;

    void change(const std::function<void(CutFinish &)> &by) const
    {
        CutFinish finish = read();
        by(finish);
        write(finish);
    }
};

LengthRow *finishLength(PropertyGroup *group, const FinishAccess &access, const QString &name,
                        const char *objectName, const LengthEdit::Range &range,
                        double CutFinish::*value)
{
    auto *row = new LengthRow(
        name, objectName, range, [access, value] { return std::optional(access.read().*value); },
        [access, value](double mm) {
            access.change([value, mm](CutFinish &finish) { finish.*value = mm; });
        },
        group);
    group->add(row);
    return row;
}

/// Of a stock without clearance.
QString slitNumberText(int number)
{
    const double clearance = clearanceOfSlit(number);
    const QString length = lengthText(std::abs(clearance), 2, 2, QLocale());
    if (clearance == 0.0)
        //: %1 is the number of a slit
        return CutRowsTexts::tr("%1: no clearance").arg(number);
    //: %1 is the number of a slit, %2 a length
    return clearance < 0.0
               ? CutRowsTexts::tr("%1: %2 narrower").arg(QString::number(number), length)
               : CutRowsTexts::tr("%1: %2 wider").arg(QString::number(number), length);
}

} // namespace

std::vector<PropertyRow *> addCutRows(PropertyGroup *group, const std::function<CutFinish()> &read,
                                      const std::function<void(const CutFinish &)> &write)
{
    const FinishAccess access{read, write};
    auto *count = new NumberEdit(kTabCount, QString(), group);
    auto *tabs = new EditorRow(
        CutRowsTexts::tr("Bridges"), "exportBridges", count,
        [read, count] { count->setNumber(read().tabs); }, group);
    tabs->setToolTip(CutRowsTexts::tr("So many short gaps in each part's cut hold it in its sheet; "
                                      "0: none"));
    QObject::connect(count, &NumberEdit::numberEdited, group, [access](double number) {
        access.change(
            [number](CutFinish &finish) { finish.tabs = static_cast<int>(std::lround(number)); });
    });
    group->add(tabs);
    LengthRow *width = finishLength(group, access, CutRowsTexts::tr("Width of bridges"),
                                    "exportBridgeWidth", kTabWidthRange, &CutFinish::tabWidth);
    LengthRow *lead = finishLength(group, access, CutRowsTexts::tr("Lead-in"), "exportLead",
                                   kLeadRange, &CutFinish::lead);
    lead->setToolTip(CutRowsTexts::tr("Each cut begins and ends so far beside its line, in the "
                                      "waste; 0: on the line"));
    auto *box = new QCheckBox(CutRowsTexts::tr("cut once"));
    auto *shared = new EditorRow(
        CutRowsTexts::tr("Shared edges"), "exportSharedCuts", box,
        [read, box] { box->setChecked(read().sharesCuts); }, group);
    shared->setToolTip(
        CutRowsTexts::tr("Of parts that lie against each other, where the spacing is 0"));
    QObject::connect(box, &QCheckBox::clicked, group, [access](bool isOn) {
        access.change([isOn](CutFinish &finish) { finish.sharesCuts = isOn; });
    });
    group->add(shared);
    return {tabs, width, lead, shared};
}

PropertyRow *fittedSlitRow(const std::function<double()> &clearance,
                           const std::function<void(double)> &write, QWidget *parent)
{
    auto *row = new ChoiceRow(
        CutRowsTexts::tr("Slit that fitted"), "exportFittedSlit",
        [clearance] {
            Choices choices;
            for (int number = 1; number <= kCouponSlits; ++number)
                choices.all.push_back({slitNumberText(number), {}});
            choices.current = slitOfClearance(clearance()) - 1;
            return choices;
        },
        [write](int choice) { write(clearanceOfSlit(choice + 1)); }, parent);
    row->setToolTip(CutRowsTexts::tr("Which of the numbered slits of a fit coupon holds the sheet "
                                     "best (cut one: menu File, or among the files for the "
                                     "workshop). It sets the clearance."));
    return row;
}

} // namespace fff::ui
