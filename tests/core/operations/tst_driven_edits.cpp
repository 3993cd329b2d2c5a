// Ten thousand edits of values and of what is made of them, and their undoing.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/core/operations/driven_models.h"
#include "tests/test_program.h"

#include <iterator>
#include <random>
#include <vector>

using namespace fff;
using namespace fff::test;

class TestDrivenEdits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void randomEditsAndUndo();
};

void TestDrivenEdits::randomEditsAndUndo()
{
    std::mt19937 random(29);
    const auto below = [&random](std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
    };
    std::vector<Document> history{withValue(shelf(), "v0", "3 mm")};
    const std::vector<DrivenPlace> places = drivablePlaces(history[0]);
    const char *const kTexts[] = {"v0 + 1 mm", "2*v0", "v0/2 + 3 mm", "9 mm", "v1 - v0", "v1*v1"};
    int changed = 0;
    for (int i = 0; i < 10000; ++i) {
        const Document &now = history.back();
        Document next = now;
        const std::size_t count = now.values.list.size();
        const ValueId id = count > 0 ? now.values.list[below(count)]->value.id : ValueId();
        switch (below(7)) {
        case 0:
            if (auto bound_ =
                    bound(now, places[below(places.size())], kTexts[below(std::size(kTexts))]))
                next = *std::move(bound_);
            break;
        case 1:
            if (count > 0)
                next = typeValue(now, id, std::to_string(1 + below(40)) + " mm", {}).value();
            break;
        case 2:
            if (count < 4)
                next = withValue(now, ("v" + std::to_string(i + 2)).c_str(), "5 mm");
            break;
        case 3:
            if (count > 0)
                if (auto renamed = renameValue(now, id, "v" + std::to_string(below(2))))
                    next = *std::move(renamed);
            break;
        case 4:
            if (count > 2)
                next = removeValue(now, id).document;
            break;
        case 5: {
            Stock stock = *now.stocks[0];
            stock.thickness = 1.0 + static_cast<double>(below(9));
            if (auto set = setStock(now, stock))
                next = *std::move(set);
            break;
        }
        default: // undo: the very document, and its model is the same again
            if (history.size() > 1) {
                history.pop_back();
                QVERIFY(evaluate(history.back()).document.isSame(history.back()));
            }
            continue;
        }
        next = evaluate(next).document;
        QVERIFY(driven(next).document.isSame(next));
        for (const BindingPointer &pointer : next.bindings) {
            const auto number = drivenNumber(next, pointer->binding.place);
            QVERIFY(number && isSameWorth(number->worth, pointer->binding.result));
        }
        changed += next.isSame(now) ? 0 : 1;
        history.push_back(std::move(next));
    }
    QVERIFY(changed > 3000);
}

FFF_TEST(TestDrivenEdits)
#include "tst_driven_edits.moc"
