#include "ui/help/HelpWords.h"

#include <QCoreApplication>

#include <algorithm>

namespace lubberline::ui {

namespace {

struct HelpText {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Help)
};

} // namespace

QString beginText()
{
    return HelpText::tr(
        "The tree at the left has types, aircraft, compasses and swings; a click or Enter opens the page of one. Ctrl+F finds any of them by words.\n"
        "A new swing (Ctrl+N): name aircraft and compass, type what datum and compass read on each heading; curve, coefficients and verdict follow every key. A guided swing (Ctrl+Shift+G) leads a crew round the base step by step.\n"
        "Mark it complete, sign it, and print report and card: all in the menus Swing and File. What is signed is frozen; an amendment is a new revision.\n"
        "Every change can be undone (Ctrl+Z), and is on the drive as soon as a field is left: there is no Save. File keeps copies: Save a copy, Back up now, Restore.\n"
        "F1 tells about the page in front. Deviation is magnetic minus compass, east positive, everywhere.");
}

QString derivationText()
{
    return HelpText::tr(
        "On the page of a swing a click on a coefficient, or Enter on it, opens where it comes from: the formula, and the figures of this swing in it. Escape closes it.\n"
        "Approximate coefficients: δ = A + B sin ψ' + C cos ψ' + D sin 2ψ' + E cos 2ψ', fitted to all readings by least squares; δ is magnetic minus compass, ψ' the compass heading.\n"
        "On the cardinal headings alone that is A = (δN + δE + δS + δW) / 4, B = (δE − δW) / 2, C = (δN − δS) / 2; the quadrantals give D = (δNE − δSE + δSW − δNW) / 4, and E = (δN − δE + δS − δW) / 4.\n"
        "What stands behind ± is the 95 % interval that the scatter of the readings leaves; rms is that scatter. Every number of the report names its method at the foot of the page.");
}

QString licenceText()
{
    return HelpText::tr(
        "Lubberline is free software: you may use, study, share and change it under the GNU General Public License, version 3 or any later version. It comes without any warranty.");
}

QString problemText()
{
    return HelpText::tr(
        "Copy or save the lines below, write down what was done and what happened, and send them to whoever keeps the program for you. They have nothing of your records in them.");
}

std::vector<std::pair<QString, QString>> glossary()
{
    std::vector<std::pair<QString, QString>> terms{
        {HelpText::tr("deviation δ"),
            HelpText::tr("magnetic heading minus compass heading; east positive: what is added to the compass to get magnetic")},
        {HelpText::tr("variation"),
            HelpText::tr("angle from true to magnetic north at a place and date, east positive; also called declination")},
        {HelpText::tr("dip"), HelpText::tr("angle of the Earth's field below the horizontal")},
        {HelpText::tr("swing"), HelpText::tr("deviation measured on a round of headings, with what stood on the aircraft then")},
        {HelpText::tr("correction swing"), HelpText::tr("a swing in which the compensator is turned; a check swing only measures")},
        {HelpText::tr("as found, as left"), HelpText::tr("before anything was adjusted; after it")},
        {HelpText::tr("datum"),
            HelpText::tr("what the magnetic heading is read from: a sight or landing compass, a painted line, the sun")},
        {HelpText::tr("nominal heading"), HelpText::tr("the heading that the aircraft was to stand on; what was read is the datum")},
        {HelpText::tr("A"), HelpText::tr("the same on all headings: lubber line, mounting, datum")},
        {HelpText::tr("B, C"), HelpText::tr("once round: hard iron fore and aft, and athwart")},
        {HelpText::tr("D, E"), HelpText::tr("twice round: soft iron")},
        {HelpText::tr("exact coefficients"), HelpText::tr("Smith's of large deviations, where B and C no longer just add up")},
        {HelpText::tr("residual"), HelpText::tr("what a fit leaves of a reading")},
        {HelpText::tr("hard iron"), HelpText::tr("field of what is magnetised and stays with the aircraft; in nT")},
        {HelpText::tr("soft iron"), HelpText::tr("field that the Earth's field induces in the aircraft")},
        {HelpText::tr("limits profile"), HelpText::tr("what a compass is held against, with its document")},
        {HelpText::tr("card"), HelpText::tr("FOR a magnetic heading STEER by compass: the placard beside the compass")},
        {HelpText::tr("slip"), HelpText::tr("a reading that does not fit the others, and what it most likely was meant to be")},
        {HelpText::tr("compass base"), HelpText::tr("a surveyed place to swing on")},
        {HelpText::tr("revision"), HelpText::tr("an amendment of what was signed; the one before stays")},
    };
    std::sort(terms.begin(), terms.end(), [](const auto& a, const auto& b) { return QString::localeAwareCompare(a.first, b.first) < 0; });
    return terms;
}

std::vector<std::pair<QString, QString>> keysEverywhere()
{
    return {{HelpText::tr("Enter"), HelpText::tr("on to the next figure; on a row of a list: opens it")},
        {HelpText::tr("Esc"), HelpText::tr("closes the message above the page; in a field: what was there before")},
        {HelpText::tr("= in the readings"), HelpText::tr("the nominal heading as read")},
        {HelpText::tr("Alt and an underlined letter"), HelpText::tr("that menu, field or button")},
        {HelpText::tr("F2, F4, F8 in a guided swing"), HelpText::tr("read a step again, leave it out, report a fault")},
        {HelpText::tr("F6, F7, F12 in a guided swing"), HelpText::tr("take what is heard as datum, as compass; listen to instruments")}};
}

std::vector<LicenceTable> licences()
{
    return {
        {HelpText::tr("Data that are built in"),
            {{HelpText::tr("World Magnetic Model 2025 (WMM)"), HelpText::tr("NOAA NCEI and British Geological Survey"),
                 HelpText::tr("public domain")},
                {QStringLiteral("IGRF-14"), HelpText::tr("IAGA Division V-MOD, doi 10.5281/zenodo.14012302"), QStringLiteral("CC BY 4.0")},
                {HelpText::tr("coastlines"), QStringLiteral("Natural Earth, 1:110m land"), HelpText::tr("public domain")},
                {HelpText::tr("samples of swings"), HelpText::tr("the manuals that they name"),
                    HelpText::tr("figures, with their source")}}},
        {HelpText::tr("Parts of the program"),
            {{QStringLiteral("Qt 6"), HelpText::tr("window, documents, storage"), QStringLiteral("LGPL-3.0")},
                {QStringLiteral("Qwt 6.3"), HelpText::tr("plots: based in part on the work of the Qwt project (http://qwt.sf.net)"),
                    HelpText::tr("LGPL-2.1, Qwt exceptions")},
                {QStringLiteral("FFTW 3"), HelpText::tr("Fourier transforms"), QStringLiteral("GPL-2.0-or-later")},
                {QStringLiteral("Eigen 3.4"), HelpText::tr("linear algebra"), QStringLiteral("MPL-2.0")},
                {QStringLiteral("GeographicLib"), HelpText::tr("the sums of the Earth's field"), QStringLiteral("MIT")},
                {QStringLiteral("Boost.Math"), HelpText::tr("quantiles"), QStringLiteral("BSL-1.0")},
                {QStringLiteral("nlohmann/json"), QStringLiteral("JSON"), QStringLiteral("MIT")},
                {QStringLiteral("CLI11"), HelpText::tr("the command line"), QStringLiteral("BSD-3-Clause")},
                {QStringLiteral("qpdf"), HelpText::tr("the data inside a report"), QStringLiteral("Apache-2.0")},
                {QStringLiteral("libqrencode"), HelpText::tr("QR codes"), QStringLiteral("LGPL-2.1-or-later")},
                {QStringLiteral("zlib"), HelpText::tr("check sum of those data"), QStringLiteral("Zlib")},
                {QStringLiteral("SQLite"), HelpText::tr("the database"), HelpText::tr("public domain")}}}};
}

QString pageName(const QString& id)
{
    const std::pair<const char*, QString> names[]
        = {{"start", HelpText::tr("An empty database")}, {"aircraft", HelpText::tr("Page of an aircraft")},
            {"swing", HelpText::tr("Page of a swing")}, {"overview", HelpText::tr("Overview of the fleet")}};
    for (const auto& [page, name] : names)
        if (id == QLatin1String(page))
            return name;
    return {};
}

} // namespace lubberline::ui
