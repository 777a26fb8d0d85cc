#pragma once
/// Published swings with published answers, in our own form.
/// The three aircraft swings are of "Compass Compensation Worksheet Examples" (QNSC PEWB), questions 1 to 3: a correction swing
/// on N E S W, then a check swing on eight headings; deviation = landing compass - aircraft compass.

#include <array>
#include <string>

namespace lubberline::test {

struct WorksheetSwing {
    std::string correction; ///< Swing CSV
    std::string check;
    double C, makeReadSouth, B, makeReadWest, A;
    std::array<int, 8> steer; ///< for 000, 045 … 315
};

inline const std::string kHeader = "magnetic_heading_deg,compass_heading_deg\n";

inline const std::array<WorksheetSwing, 3> kWorksheet{{
    {kHeader + "359,3\n91,85\n178,170\n267,265\n", kHeader + "317,316\n0,358\n47,42\n93,89\n135,134\n179,177\n225,220\n273,269\n", -6, 176,
        2, 263, 3, {1, 43, 89, 137, 181, 223, 269, 317}},
    {kHeader + "355,358\n92,92\n184,183\n272,266\n", kHeader + "318,316\n1,0\n49,47\n92,89\n137,135\n182,181\n229,227\n276,273\n", -2, 185,
        -3, 269, 2, {1, 45, 89, 135, 181, 225, 269, 315}},
    {kHeader + "2,355\n88,84\n182,185\n268,272\n", kHeader + "317,316\n0,358\n48,47\n89,89\n136,135\n183,181\n224,223\n270,270\n", 5, 180,
        4, 268, 1, {359, 45, 91, 135, 179, 225, 271, 315}},
}};

/// NGA Handbook of Magnetic Compass Adjustment (2004), art. 501: compass heading, deviation (east positive).
inline const std::string kNga501 = "compass_heading_deg,deviation_deg\n"
                                   "0,10.5\n45,20.0\n90,11.5\n135,-1.2\n180,-5.5\n225,-8.0\n270,-12.5\n315,-6.8\n";

/// A flux valve after MIL-STD-765A as worked by Duncan Aviation; its error, indicated - actual, is +6, 0, -5, +6 on N E S W.
inline const std::string kMilStd765 = kHeader + "0,6\n90,90\n180,175\n270,276\n";

} // namespace lubberline::test
