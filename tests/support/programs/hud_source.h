// QuakeC of HUD programs: the declarations that tests need, and two small programs, in the two styles.
#pragma once

#include <string_view>

namespace temblor::test {

// Declared as csprogs sources do, by number and by name.
inline constexpr std::string_view kHudDeclarations = R"(
entity self, other, world;
float time, frametime, maxclients, intermission, player_localentnum, sb_showscores;
vector view_angles, v_forward, v_right, v_up;
void end_sys_globals;
.string classname;
.float score;
void end_sys_fields;

void(string s, ...) error = #10;
entity() spawn = #14;
void(entity e) remove = #15;
string(float f) ftos = #26;
float(string s) stof = #81;
float(string name) cvar = #45;
void(string s, ...) localcmd = #46;
entity(entity e) nextent = #47;
float(string name) checkextension = #99;
string(string s, ...) strcat = #115;
string(string s, float start, float length) substring = #116;
string(string s, ...) strzone = #118;
void() clearscene = #300;
void(float mask) addentities = #301;
float(float property, ...) setproperty = #303;
void() renderscene = #304;
vector(float property) getproperty_v = #309;
void(float width, vector from, vector to, vector rgb, float alpha, float flag) drawline = #315;
float(string name) iscachedpic = #316;
string(string name, float flags) precache_pic = #317;
vector(string name) drawgetimagesize = #318;
float(vector place, float code, vector size, vector rgb, float alpha, float flag) drawcharacter = #320;
float(vector place, string text, vector size, vector rgb, float alpha, float flag) drawrawstring = #321;
float(vector place, string name, vector size, vector rgb, float alpha, float flag) drawpic = #322;
float(vector place, vector size, vector rgb, float alpha, float flag) drawfill = #323;
void(float x, float y, float width, float height) drawsetcliparea = #324;
void() drawresetcliparea = #325;
float(vector place, string text, vector size, vector rgb, float alpha, float flag) drawstring = #326;
float(string text, float codes, vector size) stringwidth = #327;
void(vector place, vector size, string name, vector from, vector part, vector rgb, float alpha, float flag) drawsubpic = #328;
float(float stat) getstati = #330;
float(float stat, ...) getstatf = #331;
string(float stat) getstats = #332;
void(string s, ...) print = #339;
string(float key) keynumtostring = #340;
float(string name) stringtokeynum = #341;
void(float on) setcursormode = #343;
vector() getmousepos = #344;
string(float player, string key) getplayerkeyvalue = #348;
void(string name) registercommand = #352;
string(string key) serverkey = #354;
string(string s, ...) sprintf = #627;
vector(float x, float y) at = { local vector v; v_x = x; v_y = y; return v; };
)";

// Draws a red band and the health over it, and a green band while the scores are shown.
inline constexpr std::string_view kModernHud = R"(
void(vector size, float shows_scores) CSQC_DrawHud = {
  drawfill(at(0, size_y - 24), at(size_x, 24), '1 0 0', 1, 0);
  drawstring(at(8, size_y - 16), ftos(getstatf(0)), '8 8 0', '1 1 1', 1, 0);
};
void(vector size, float shows_scores) CSQC_DrawScores = {
  drawfill('0 0 0', at(size_x, 16), '0 1 0', 1, 0);
};
)";

// The same band in the older style: asks for the view, and draws over it.
inline constexpr std::string_view kOlderHud = R"(
float last_key, eaten;
void(float api, string name, float version) CSQC_Init = {
  registercommand("paint");
};
void(float width, float height, float notmenu) CSQC_UpdateView = {
  drawfill('0 0 0', at(width, height), '0 0 1', 1, 0);
  clearscene();
  setproperty(20, 0);
  addentities(7);
  renderscene();
  drawfill(at(0, height - 24), at(width, 24), '1 0 0', 1, 0);
  if (eaten) drawfill('0 0 0', '16 16 0', '0 1 0', 1, 0);
};
float(string text) CSQC_ConsoleCommand = {
  eaten = 1;
  print("painted: ", text, "\n");
  return 1;
};
float(float type, float a, float b, float device) CSQC_InputEvent = {
  if (type == 0) print(sprintf("key %g %s\n", a, keynumtostring(a)));
  return type == 0 && a == 120;
};
)";

}  // namespace temblor::test
