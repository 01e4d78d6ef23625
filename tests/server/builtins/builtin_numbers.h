// The numbers and names of built-in functions, as quake-facts.md lists them (sections 15 and 18). Copied from
// there by hand, independently of src.
#pragma once

#include <string_view>

namespace temblor::test {

struct BuiltinNumber {
  int number;
  std::string_view name;
};

constexpr BuiltinNumber kStockBuiltins[] = {
    {1, "makevectors"},
    {2, "setorigin"},
    {3, "setmodel"},
    {4, "setsize"},
    {6, "break"},
    {7, "random"},
    {8, "sound"},
    {9, "normalize"},
    {10, "error"},
    {11, "objerror"},
    {12, "vlen"},
    {13, "vectoyaw"},
    {14, "spawn"},
    {15, "remove"},
    {16, "traceline"},
    {17, "checkclient"},
    {18, "find"},
    {19, "precache_sound"},
    {20, "precache_model"},
    {21, "stuffcmd"},
    {22, "findradius"},
    {23, "bprint"},
    {24, "sprint"},
    {25, "dprint"},
    {26, "ftos"},
    {27, "vtos"},
    {28, "coredump"},
    {29, "traceon"},
    {30, "traceoff"},
    {31, "eprint"},
    {32, "walkmove"},
    {34, "droptofloor"},
    {35, "lightstyle"},
    {36, "rint"},
    {37, "floor"},
    {38, "ceil"},
    {40, "checkbottom"},
    {41, "pointcontents"},
    {43, "fabs"},
    {44, "aim"},
    {45, "cvar"},
    {46, "localcmd"},
    {47, "nextent"},
    {48, "particle"},
    {49, "ChangeYaw"},
    {51, "vectoangles"},
    {52, "WriteByte"},
    {53, "WriteChar"},
    {54, "WriteShort"},
    {55, "WriteLong"},
    {56, "WriteCoord"},
    {57, "WriteAngle"},
    {58, "WriteString"},
    {59, "WriteEntity"},
    {67, "movetogoal"},
    {68, "precache_file"},
    {69, "makestatic"},
    {70, "changelevel"},
    {72, "cvar_set"},
    {73, "centerprint"},
    {74, "ambientsound"},
    {75, "precache_model2"},
    {76, "precache_sound2"},
    {77, "precache_file2"},
    {78, "setspawnparms"},
};

constexpr BuiltinNumber kExtensionBuiltins[] = {
    {99, "checkextension"},
    {60, "sin"},
    {61, "cos"},
    {62, "sqrt"},
    {97, "pow"},
    {94, "min"},
    {95, "max"},
    {96, "bound"},
    {91, "randomvec"},
    {90, "tracebox"},
    {65, "etos"},
    {93, "registercvar"},
    {98, "findfloat"},
    {81, "stof"},
    {110, "fopen"},
    {111, "fclose"},
    {112, "fgets"},
    {113, "fputs"},
    {114, "strlen"},
    {115, "strcat"},
    {116, "substring"},
    {117, "stov"},
    {118, "strzone"},
    {119, "strunzone"},
    {400, "copyentity"},
    {402, "findchain"},
    {403, "findchainfloat"},
    {448, "cvar_string"},
    {453, "dropclient"},
    {454, "spawnclient"},
    {455, "clienttype"},
    {503, "whichpack"},
    {449, "findflags"},
    {440, "clientcommand"},
    {441, "tokenize"},
    {442, "argv"},
    {627, "sprintf"},
};

constexpr std::string_view kNamedBuiltins[] = {"ex_bprint", "ex_sprint", "ex_centerprint", "ex_localsound",
                                               "ex_finaleFinished"};

// Functions of a Stage's program exist for the numbers 0 to this.
constexpr int kMaxBuiltin = 700;

}  // namespace temblor::test
