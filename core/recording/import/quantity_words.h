// The words of which names of columns are made.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "recording/import/units.h"

namespace breakaway {

/// What a word names. `weak` words count only where no other does: single letters, and what often stands before others.
struct Word {
  std::string_view text;
  UnitKind kind;
  bool weak = false;
  std::string_view usual = {};  ///< the unit in which people count it where none is told: a Drehzahl is in rpm
};

/// The quantity that the word names, also as the end of a German compound ("Motorstrom"); nullptr when it names none.
const Word* quantityNamed(std::string_view word);

/// Where the quantity begins at the end of a word that is written without gaps (Chinese, Japanese); 0 when it doesn't.
size_t quantityAtEnd(std::string_view word);

/// How many different words of quantities that have other letters than English the text holds.
size_t foreignWordsIn(std::string_view text);

inline constexpr auto referenceWords = std::to_array<std::string_view>(
    {"ref",       "reference", "target",   "goal",     "setpoint",   "sp",          "cmd",      "command",  "commanded",
     "desired",   "des",       "demand",   "demanded", "dem",        "soll",        "set",      "sollwert", "request",
     "requested", "req",       "tgt",      "trg",      "目标",       "目標",        "设定",     "設定",     "给定",
     "指令",      "期望",      "consigne", "consigna", "referencia", "riferimento", "objetivo", "alvo",     "cible",
     "zadana",    "vorgabe",   "指令値",   "目標値",   "目标值",     "设定值",      "設定値",   "给定值"});
inline constexpr auto supplyWords = std::to_array<std::string_view>(
    {"supply", "bus",   "vbus", "vdc",  "dc",       "battery", "batt",  "bat",  "vbat", "vbatt",  "vin",
     "dclink", "input", "bms",  "pack", "esc",      "psu",     "dcbus", "udc",  "udcb", "udcbus", "vdcbus",
     "vfas",   "uzk",   "zk",   "hv",   "traction", "母线",    "母線",  "电源", "电池"});
/// May stand behind the quantity and change nothing.
inline constexpr auto decorations = std::to_array<std::string_view>(
    {"actual",   "act",        "measured",  "meas",       "measurement", "present",   "motor",    "mot",
     "shaft",    "rotor",      "encoder",   "enc",        "joint",       "axis",      "value",    "val",
     "values",   "ist",        "istwert",   "feedback",   "fb",          "stamp",     "cycle",    "estimate",
     "est",      "estimated",  "estimator", "filtered",   "filt",        "lpf",       "now",      "data",
     "output",   "out",        "raw",       "state",      "states",      "q",         "mech",     "m",
     "r",        "mechanical", "today",     "shadow",     "total",       "latest",    "per",      "of",
     "the",      "link",       "angular",   "in",         "since",       "start",     "averaged", "average",
     "avg",      "smoothed",   "smooth",    "rel",        "generating",  "producing", "voltage",  "current",
     "sensor",   "transducer", "geglättet", "geglaettet", "reading",     "read",      "channel",  "ch",
     "sec",      "msr",        "measure",   "real",       "true",        "mesuré",    "mesurée",  "mesure",
     "réel",     "réelle",     "moteur",    "medido",     "medida",      "misurata",  "misurato", "atual",
     "actuelle", "gemessen",   "gemessene", "aktuell",    "实际",        "測定",      "实测",     "反馈",
     "revolute", "prismatic",  "telemetry", "pll",        "observer",    "observed",  "obs",      "hat",
     "kf",       "ekf",        "kalman",    "smo",        "sensorless",  "fdb",       "fbk",      "fdk",
     "used",     "wrapped",    "unwrapped", "applied",    "j",           "ave",       "mean",     "wirk",
     "winding",  "wicklung",   "wick"});
/// Before a reference they tell who follows it.
inline constexpr auto loopWords =
    std::to_array<std::string_view>({"mcu", "controller", "control", "pid", "loop", "plc"});
/// Wherever they stand, the column is something else.
inline constexpr auto otherThings =
    std::to_array<std::string_view>({"error",        "err",          "limit",         "lim",          "max",
                                     "min",          "peak",         "integral",      "integrator",   "std",
                                     "rms",          "gain",         "offset",        "threshold",    "mode",
                                     "fault",        "derivative",   "ripple",        "tolerance",    "delta",
                                     "diff",         "difference",   "deviation",     "fehler",       "gyro",
                                     "gyroadc",      "gyroscope",    "accelerometer", "magnetometer", "imu",
                                     "accel",        "acceleration", "acc",           "mag",          "gps",
                                     "gnss",         "vehicle",      "variance",      "covariance",   "correction",
                                     "compensation", "power",        "energy",        "ratio",        "sum",
                                     "abs",          "dt",           "delay",         "duration",     "regelabweichung",
                                     "bandwidth",    "sin",          "cos",           "tan",          "predicted",
                                     "prediction",   "predict",      "simulated",     "sim",          "modeled",
                                     "modelled",     "ideal",        "expected",      "theoretical",  "wind",
                                     "unsaturated",  "unsat",        "unclamped",     "unlimited",    "pred",
                                     "nominal",      "prev",         "previous",      "old",          "initial",
                                     "init",         "final",        "home",          "bias",         "noise",
                                     "fan",          "pump",         "injector",      "heater",       "led",
                                     "urms",         "irms",         "vrms",          "kmh",          "kph",
                                     "kmph",         "mph",          "watt",          "wh",           "ah"});
/// The first of the words that makes a column something else; nullptr when none does. Where words are written without
/// gaps, it may end one ("位置偏差").
const std::string* otherThingIn(const std::vector<std::string>& words);
/// Of these a vehicle or a hand turns about one; of a joint they are the name.
inline constexpr auto headings = std::to_array<std::string_view>({"roll", "pitch", "yaw", "tilt", "lean"});
inline constexpr auto jointWords = std::to_array<std::string_view>(
    {"joint",   "joints", "motor", "mot",   "servo", "actuator", "wrist",   "forearm", "elbow",   "shoulder",
     "gripper", "hip",    "knee",  "ankle", "waist", "gimbal",   "encoder", "enc",     "stepper", "blade"});
inline constexpr auto loadWords =
    std::to_array<std::string_view>({"load", "external", "friction", "disturbance", "gravity", "cogging", "brake",
                                     "braking", "bremse", "frein", "freno", "carga", "feedforward", "ff"});
/// Signals of a vehicle or a board, and other machines': a current or a voltage called so is none of a motor's.
inline constexpr auto otherSources = std::to_array<std::string_view>(
    {"throttle",      "brake", "pedal", "accelerator", "apps", "mppt",  "solar", "panel",  "pv",    "charger",   "pot",
     "potentiometer", "hall",  "cell",  "logic",       "usb",  "shunt", "light", "lights", "field", "excitation"});
inline constexpr auto driverWords = std::to_array<std::string_view>(
    {"fet",    "mos",  "mosfet",  "driver",   "controller", "mcu",      "board",  "ambient", "esc", "ctrl",   "drv",
     "inv",    "bms",  "pack",    "cell",     "battery",    "coolant",  "oil",    "water",   "air", "intake", "exhaust",
     "engine", "room", "charger", "inverter", "cpu",        "heatsink", "bridge", "encoder", "pcb", "baro",   "imu"});
/// Motion counted in electrical turns.
inline constexpr auto electricalWords =
    std::to_array<std::string_view>({"electrical", "electric", "elec", "elektrisch", "电", "電", "电气", "電気"});
/// Behind a gear or a coupling: taken only where the motor's own isn't there.
inline constexpr auto drivenWords =
    std::to_array<std::string_view>({"load", "link", "output", "slave", "secondary", "arm", "gear", "driven", "wheel"});

/// Words that say that something was measured, beside what shall be or what was reckoned.
inline constexpr auto measuredWords = std::to_array<std::string_view>(
    {"fb", "fbk", "fdb", "feedback", "act", "actual", "meas", "measured", "msr", "ist", "istwert"});
/// Not measured but reckoned: taken only where what was measured isn't there.
inline constexpr auto estimateWords =
    std::to_array<std::string_view>({"hat", "est", "estimate", "estimated", "estimator", "observer", "observed", "obs",
                                     "kf", "ekf", "kalman", "smo", "sensorless"});

}  // namespace breakaway
