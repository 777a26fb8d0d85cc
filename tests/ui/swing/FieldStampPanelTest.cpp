// The field that a swing keeps: shown, held against site, date and model, and taken anew as an edit that can be undone.

#include <QPushButton>

#include "core/swing/SwingField.h"
#include "tests/ui/window/Fixture.h"

using namespace lubberline;
using namespace lubberline::ui;

class FieldStampPanelTest : public QObject {
    Q_OBJECT

private slots:
    void aNewSwingIsStampedAndItsFieldIsShown();
    void withoutAPlaceNothingIsShown();
    void anOldSwingGetsOneWhenItIsAsked();
    void anotherModelIsSaidAndTakenUndoably();
    void anotherSiteIsSaid();
    void aSignedSwingKeepsWhatItHas();
    void aDoubtfulVariationIsSaid();

private:
    static SiteId siteAt(SmallFleet& fleet, const std::string& name, double latitude_deg, double longitude_deg)
    {
        Site site;
        site.name = name;
        site.latitude_deg = latitude_deg;
        site.longitude_deg = longitude_deg;
        return *fleet.stores.save(site);
    }
    static SwingId swingAt(SmallFleet& fleet, SiteId site)
    {
        Swing swing;
        swing.compass = fleet.compass;
        swing.site = site;
        swing.date = "2026-03-10";
        return *fleet.stores.swings.add(swing);
    }
    static Swing stored(SmallFleet& fleet, SwingId id) { return *fleet.stores.swings.swing(id); }
};

void FieldStampPanelTest::aNewSwingIsStampedAndItsFieldIsShown()
{
    SmallFleet fleet;
    const SwingId id = swingAt(fleet, siteAt(fleet, "Deblin", 51.55, 21.89));
    QVERIFY(stored(fleet, id).field);
    OpenWindow open(fleet.stores);
    open.window.go(id);
    const QString values = open.label("fieldValues");
    QVERIFY2(values.contains("H 19") && values.contains("dip +67") && values.contains("WMM2025 for 2026-03-10"), qPrintable(values));
    QVERIFY(open.label("fieldDifference").isEmpty());
    QVERIFY(!open.find<QPushButton>("takeField").isVisible());
    QVERIFY(!open.find<QLabel>("fieldVariation").isVisible());
}

void FieldStampPanelTest::withoutAPlaceNothingIsShown()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    QVERIFY(!open.find<QWidget>("fieldStampPanel").isVisible());
}

void FieldStampPanelTest::anOldSwingGetsOneWhenItIsAsked()
{
    SmallFleet fleet;
    const SwingId id = swingAt(fleet, siteAt(fleet, "Deblin", 51.55, 21.89));
    Swing old = stored(fleet, id);
    old.field.reset();
    QVERIFY(fleet.stores.put(old));
    OpenWindow open(fleet.stores);
    open.window.go(id);
    QVERIFY(!stored(fleet, id).field);
    QVERIFY(open.label("fieldValues").contains("not kept"));
    open.find<QPushButton>("takeField").click();
    QVERIFY(stored(fleet, id).field);
    QVERIFY(open.label("fieldValues").contains("WMM2025"));
    open.trigger("undo");
    QVERIFY(!stored(fleet, id).field);
    open.trigger("redo");
    QVERIFY(stored(fleet, id).field);
}

void FieldStampPanelTest::anotherModelIsSaidAndTakenUndoably()
{
    SmallFleet fleet;
    const SwingId id = swingAt(fleet, siteAt(fleet, "Deblin", 51.55, 21.89));
    const FieldStamp today = *stored(fleet, id).field;
    FieldStamp old = today;
    old.model = "WMM2020";
    old.field.north_nT -= 30;
    Swing other = stored(fleet, id);
    other.field = old;
    QVERIFY(fleet.stores.put(other));
    OpenWindow open(fleet.stores);
    open.window.go(id);
    QVERIFY(open.label("fieldValues").contains("WMM2020")); // what it was computed with stays
    QVERIFY2(open.label("fieldDifference").contains("By WMM2025 it is now"), qPrintable(open.label("fieldDifference")));
    QVERIFY(open.find<QPushButton>("takeField").isVisible());
    open.find<QPushButton>("takeField").click();
    QVERIFY(stored(fleet, id).field == today);
    QVERIFY(open.label("fieldDifference").isEmpty());
    QVERIFY(!open.find<QPushButton>("takeField").isVisible());
    open.trigger("undo");
    QVERIFY(stored(fleet, id).field == old);
    QVERIFY(!open.label("fieldDifference").isEmpty());
}

void FieldStampPanelTest::anotherSiteIsSaid()
{
    SmallFleet fleet;
    const SiteId north = siteAt(fleet, "Tromso", 69.68, 18.92);
    const SwingId id = swingAt(fleet, siteAt(fleet, "Deblin", 51.55, 21.89));
    OpenWindow open(fleet.stores);
    open.window.go(id);
    Swing moved = stored(fleet, id);
    moved.site = north;
    QVERIFY(fleet.stores.put(moved));
    QVERIFY2(open.label("fieldDifference").contains("Site or date have changed"), qPrintable(open.label("fieldDifference")));
    open.find<QPushButton>("takeField").click();
    QCOMPARE(stored(fleet, id).field->place.latitude_deg, 69.68);
}

void FieldStampPanelTest::aSignedSwingKeepsWhatItHas()
{
    SmallFleet fleet;
    const SwingId id = swingAt(fleet, siteAt(fleet, "Deblin", 51.55, 21.89));
    Swing frozen = stored(fleet, id);
    frozen.field->field.north_nT -= 30;
    frozen.state = SwingState::Signed;
    QVERIFY(fleet.stores.put(frozen));
    OpenWindow open(fleet.stores);
    open.window.go(id);
    QVERIFY(!open.label("fieldDifference").isEmpty());
    QVERIFY(!open.find<QPushButton>("takeField").isVisible());
}

void FieldStampPanelTest::aDoubtfulVariationIsSaid()
{
    SmallFleet fleet;
    const SwingId id = swingAt(fleet, siteAt(fleet, "Deblin", 51.55, 21.89));
    const double declination_deg = stored(fleet, id).field->field.variation().degrees();
    Swing other = stored(fleet, id);
    other.variation_deg = declination_deg - 0.9;
    QVERIFY(fleet.stores.put(other));
    OpenWindow open(fleet.stores);
    open.window.go(id);
    QVERIFY(!open.find<QLabel>("fieldVariation").isVisible());
    Swing doubtful = stored(fleet, id);
    doubtful.variation_deg = -declination_deg; // west for east
    QVERIFY(fleet.stores.put(doubtful));
    QVERIFY(open.find<QLabel>("fieldVariation").isVisible());
    QVERIFY2(open.label("fieldVariation").contains("differs by"), qPrintable(open.label("fieldVariation")));
    // The swing states nothing, and the base and its survey disagree.
    doubtful.variation_deg.reset();
    QVERIFY(fleet.stores.put(doubtful));
    QVERIFY(!open.find<QLabel>("fieldVariation").isVisible());
    Site site = **fleet.stores.sites.site(doubtful.site);
    site.variation_deg = declination_deg + 1.4;
    QVERIFY(fleet.stores.save(site));
    fleet.stores.changes().announceFleet();
    QVERIFY(open.find<QLabel>("fieldVariation").isVisible());
    QVERIFY2(open.label("fieldVariation").contains("the base states"), qPrintable(open.label("fieldVariation")));
}

QTEST_MAIN(FieldStampPanelTest)
#include "FieldStampPanelTest.moc"
