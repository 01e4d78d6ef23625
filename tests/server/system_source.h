// The system definitions in QuakeC, in the order of quake-facts.md (section 15), with which every program
// for Quake begins. The compiler's checksum of them is 5927.
#pragma once

namespace temblor::test {

constexpr char kSystemSource[] = R"(
entity self, other, world;
float time, frametime, force_retouch;
string mapname;
float deathmatch, coop, teamplay, serverflags, total_secrets, total_monsters, found_secrets, killed_monsters;
float parm1, parm2, parm3, parm4, parm5, parm6, parm7, parm8;
float parm9, parm10, parm11, parm12, parm13, parm14, parm15, parm16;
vector v_forward, v_up, v_right;
float trace_allsolid, trace_startsolid, trace_fraction;
vector trace_endpos, trace_plane_normal;
float trace_plane_dist;
entity trace_ent;
float trace_inopen, trace_inwater;
entity msg_entity;
void() main, StartFrame, PlayerPreThink, PlayerPostThink, ClientKill, ClientConnect, PutClientInServer,
  ClientDisconnect, SetNewParms, SetChangeParms;
void end_sys_globals;

.float modelindex;
.vector absmin, absmax;
.float ltime, movetype, solid;
.vector origin, oldorigin, velocity, angles, avelocity, punchangle;
.string classname, model;
.float frame, skin, effects;
.vector mins, maxs, size;
.void() touch, use, think, blocked;
.float nextthink;
.entity groundentity;
.float health, frags, weapon;
.string weaponmodel;
.float weaponframe, currentammo, ammo_shells, ammo_nails, ammo_rockets, ammo_cells, items, takedamage;
.entity chain;
.float deadflag;
.vector view_ofs;
.float button0, button1, button2, impulse, fixangle;
.vector v_angle;
.float idealpitch;
.string netname;
.entity enemy;
.float flags, colormap, team, max_health, teleport_time, armortype, armorvalue, waterlevel, watertype, ideal_yaw,
  yaw_speed;
.entity aiment, goalentity;
.float spawnflags;
.string target, targetname;
.float dmg_take, dmg_save;
.entity dmg_inflictor, owner;
.vector movedir;
.string message;
.float sounds;
.string noise, noise1, noise2, noise3;
void end_sys_fields;
)";

}  // namespace temblor::test
