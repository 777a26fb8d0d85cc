#include "ui/audit/AuditWords.h"

#include <QCoreApplication>
#include <QStringList>

#include <map>
#include <optional>

#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct AuditTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::AuditWords)
};

const QString kArrow = QStringLiteral(" -> ");

/// "changed_reading": what is stored, as one word.
QString codeOf(QString deed) { return deed.replace(u' ', u'_'); }

QString deedWords(const QString& deed)
{
    const std::map<QString, QString> words{{"added_swing", AuditTexts::tr("swing made")},
        {"changed_swing", AuditTexts::tr("particulars changed")}, {"removed_swing", AuditTexts::tr("swing removed")},
        {"added_reading", AuditTexts::tr("reading added")}, {"changed_reading", AuditTexts::tr("reading changed")},
        {"removed_reading", AuditTexts::tr("reading removed")}, {"set_readings", AuditTexts::tr("readings put in")},
        {"completed_swing", AuditTexts::tr("marked complete")}, {"reopened_swing", AuditTexts::tr("opened again")},
        {"signed_swing", AuditTexts::tr("signed")}, {"imported_signature", AuditTexts::tr("signed, and imported so")},
        {"kept_signature", AuditTexts::tr("signed before the trail was a chain")}, {"froze_swing", AuditTexts::tr("frozen")},
        {"amended_swing", AuditTexts::tr("amended: a new revision")}, {"added_guided_swing", AuditTexts::tr("guided swing begun")},
        {"finished_guided_swing", AuditTexts::tr("guided swing finished")},
        {"abandoned_guided_swing", AuditTexts::tr("guided swing abandoned")}};
    const auto found = words.find(codeOf(deed));
    return found == words.end() ? deed : found->second;
}

QString fieldWords(const QString& field)
{
    const std::map<QString, QString> words{{"nominal", AuditTexts::tr("nominal heading")}, {"magnetic", AuditTexts::tr("magnetic heading")},
        {"compass", AuditTexts::tr("compass heading")}, {"true", AuditTexts::tr("true heading")}, {"pitch", AuditTexts::tr("pitch")},
        {"roll", AuditTexts::tr("roll")}, {"excluded:", AuditTexts::tr("left out because")}, {"note:", AuditTexts::tr("note")},
        {"site_id", AuditTexts::tr("site")}, {"compass_id", AuditTexts::tr("compass")}, {"date", AuditTexts::tr("date")},
        {"kind", AuditTexts::tr("kind")}, {"stage", AuditTexts::tr("stage")}, {"state", AuditTexts::tr("state")},
        {"radio", AuditTexts::tr("radio")}, {"engines", AuditTexts::tr("engines")}, {"electrics", AuditTexts::tr("electrics")},
        {"other_configuration", AuditTexts::tr("further configuration")}, {"datum_instrument", AuditTexts::tr("datum instrument")},
        {"datum_serial_number", AuditTexts::tr("serial number of the datum")},
        {"datum_calibration_due", AuditTexts::tr("datum calibrated until")}, {"datum_reader", AuditTexts::tr("datum read by")},
        {"cockpit_reader", AuditTexts::tr("compass read by")}, {"adjuster", AuditTexts::tr("adjusted by")},
        {"inspector", AuditTexts::tr("inspected by")}, {"variation_deg", AuditTexts::tr("variation (°, E +)")},
        {"shared_error_deg", AuditTexts::tr("errors that all readings share (°)")}, {"procedure_name", AuditTexts::tr("procedure")},
        {"work_order", AuditTexts::tr("work order")}, {"reason", AuditTexts::tr("reason")}, {"note", AuditTexts::tr("note")},
        {"index_removed_deg", AuditTexts::tr("A taken out (°)")}, {"weather", AuditTexts::tr("weather")},
        {"site_override", AuditTexts::tr("why on this site")}, {"datum_read_out", AuditTexts::tr("how the datum is read")},
        {"start_utc", AuditTexts::tr("begun (UTC)")}, {"end_utc", AuditTexts::tr("ended (UTC)")},
        {"field_model", AuditTexts::tr("field model")}, {"amendment", AuditTexts::tr("why amended")},
        {"revision", AuditTexts::tr("revision")}};
    const auto found = words.find(field);
    return found == words.end() ? field : found->second;
}

/// Stored as the place in its list.
template <class Choice>
QString choiceAt(const QString& value)
{
    bool number = false;
    const int place = value.toInt(&number);
    const QStringList words = choiceWords<Choice>();
    return number && place >= 0 && place < words.size() ? words[place] : value;
}

QString valueWords(const QString& field, const QString& value)
{
    if (value.isEmpty())
        return value;
    if (field == "kind")
        return choiceAt<SwingKind>(value);
    if (field == "stage")
        return choiceAt<SwingStage>(value);
    if (field == "state")
        return choiceAt<SwingState>(value);
    if (field == "radio")
        return choiceAt<RadioState>(value);
    return value;
}

/// "nominal 90, magnetic 90.5, compass 88, note: gust, and more": a note goes on to the next word that is known.
std::map<QString, QString> figuresOf(const QString& text)
{
    static const QStringList kNames{"nominal", "magnetic", "compass", "true", "pitch", "roll", "excluded:", "note:", "extra", "figures"};
    std::map<QString, QString> figures;
    QString last;
    for (const QString& part : text.split(QStringLiteral(", "))) {
        const QString name = part.section(u' ', 0, 0);
        if (kNames.contains(name) && !figures.contains(name)) {
            last = name;
            figures[name] = part.section(u' ', 1);
        } else if (!last.isEmpty()) {
            figures[last] += QStringLiteral(", ") + part;
        }
    }
    return figures;
}

QString angleFigure(const QString& name, const QString& value)
{
    const bool angle = !value.isEmpty() && !name.endsWith(u':') && name != "extra" && name != "figures";
    return angle ? value + u'°' : value;
}

/// What stands in a reading, as a line of words.
QString readingWords(const QString& text)
{
    QStringList words;
    for (const char* name : {"nominal", "magnetic", "compass", "true", "pitch", "roll", "excluded:", "note:"})
        if (const auto figures = figuresOf(text); figures.contains(name))
            words += fieldWords(name) + u' ' + angleFigure(name, figures.at(name));
    return words.isEmpty() ? AuditTexts::tr("nothing read") : words.join(QStringLiteral(", "));
}

void addReadingChange(std::vector<AuditLine>& lines, const AuditLine& whole, const QString& detail)
{
    const qsizetype arrow = detail.indexOf(kArrow);
    const auto before = figuresOf(detail.left(arrow)), after = figuresOf(detail.mid(arrow + kArrow.size()));
    const auto at = [](const std::map<QString, QString>& figures, const QString& name) {
        const auto found = figures.find(name);
        return found == figures.end() ? QString() : found->second;
    };
    QString place = at(before, "nominal");
    if (place.isEmpty())
        place = at(before, "magnetic").isEmpty() ? at(after, "magnetic") : at(before, "magnetic");
    for (const char* name : {"nominal", "magnetic", "compass", "true", "pitch", "roll", "excluded:", "note:"}) {
        const QString was = at(before, name), is = at(after, name);
        if (was == is)
            continue;
        AuditLine line = whole;
        line.what = place.isEmpty() ? AuditTexts::tr("%1 of a reading").arg(fieldWords(name))
                                    : AuditTexts::tr("%1 of the reading on %2°").arg(fieldWords(name), place);
        line.before = angleFigure(name, was);
        line.after = angleFigure(name, is);
        lines.push_back(line);
    }
}

void addFieldChanges(std::vector<AuditLine>& lines, const AuditLine& whole, const QString& detail)
{
    for (const QString& part : detail.split(QStringLiteral("; "))) {
        const QString field = part.section(QStringLiteral(": "), 0, 0), value = part.section(QStringLiteral(": "), 1);
        const qsizetype arrow = value.indexOf(kArrow);
        AuditLine line = whole;
        line.what = fieldWords(field);
        line.before = arrow < 0 ? QString() : valueWords(field, value.left(arrow));
        line.after = valueWords(field, arrow < 0 ? value : value.mid(arrow + kArrow.size()));
        lines.push_back(line);
    }
}

/// "inspector: Ada 12, hash 0f…": the hash stands with the signature.
void addSignature(std::vector<AuditLine>& lines, AuditLine line, const QString& detail)
{
    const QString named = detail.section(QStringLiteral(", hash "), 0, 0);
    line.who = named.section(QStringLiteral(": "), 1).trimmed();
    line.after = AuditTexts::tr("as %1").arg(named.section(QStringLiteral(": "), 0, 0));
    lines.push_back(line);
}

} // namespace

std::vector<AuditLine> auditLines(const AuditRow& row)
{
    const QString deed = toText(row.what), code = codeOf(deed), detail = toText(row.detail);
    const AuditLine whole{toText(row.timeUtc).left(19).replace(u'T', u' '), deedWords(deed), {}, {}, {}};
    std::vector<AuditLine> lines;
    if (code == "changed_reading" && detail.contains(kArrow))
        addReadingChange(lines, whole, detail);
    else if (code == "changed_swing")
        addFieldChanges(lines, whole, detail);
    else if (code == "signed_swing" || code == "imported_signature" || code == "kept_signature")
        addSignature(lines, whole, detail);
    if (!lines.empty())
        return lines;
    AuditLine line = whole;
    if (code == "removed_reading")
        line.before = readingWords(detail);
    else if (code == "added_reading")
        line.after = readingWords(detail);
    else if (code == "set_readings")
        line.after = AuditTexts::tr("%n reading(s)", nullptr, static_cast<int>(detail.count(QStringLiteral("reading: "))));
    else if (code != "added_swing")
        line.after = detail;
    return {line};
}

} // namespace lubberline::ui
