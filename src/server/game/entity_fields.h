// The fields that every Quake program gives its entities, and the numbers that they hold. Their offsets are
// fixed for programs with header CRC 5927 (quake-facts.md, section 15). A program's own fields follow from
// word 105 on; parts that need one (gravity, alpha, items2) look it up by name.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "math/vec.h"
#include "vm/program.h"

namespace temblor::server {

// A field of type T: the offset of its first word in an entity.
template <typename T>
struct Field {
  std::uint32_t word;
  bool operator==(const Field&) const = default;
};

namespace field {
constexpr Field<float> kModelIndex{0};
constexpr Field<math::Vec3> kAbsMin{1}, kAbsMax{4};
constexpr Field<float> kLocalTime{7};  // "ltime": a pusher's own clock
constexpr Field<float> kMoveType{8}, kSolid{9};
constexpr Field<math::Vec3> kOrigin{10}, kOldOrigin{13}, kVelocity{16}, kAngles{19}, kAngularVelocity{22},
    kPunchAngle{25};
constexpr Field<vm::StringIndex> kClassName{28}, kModel{29};
constexpr Field<float> kFrame{30}, kSkin{31}, kEffects{32};
constexpr Field<math::Vec3> kMins{33}, kMaxs{36}, kSize{39};
constexpr Field<vm::FunctionIndex> kTouch{42}, kUse{43}, kThink{44}, kBlocked{45};
constexpr Field<float> kNextThink{46};
constexpr Field<vm::EntityIndex> kGroundEntity{47};
constexpr Field<float> kHealth{48}, kFrags{49}, kWeapon{50};
constexpr Field<vm::StringIndex> kWeaponModel{51};
constexpr Field<float> kWeaponFrame{52}, kCurrentAmmo{53}, kAmmoShells{54}, kAmmoNails{55}, kAmmoRockets{56},
    kAmmoCells{57}, kItems{58}, kTakeDamage{59};
constexpr Field<vm::EntityIndex> kChain{60};
constexpr Field<float> kDeadFlag{61};
constexpr Field<math::Vec3> kViewOffset{62};
constexpr Field<float> kButton0{65}, kButton1{66}, kButton2{67}, kImpulse{68}, kFixAngle{69};
constexpr Field<math::Vec3> kViewAngles{70};
constexpr Field<float> kIdealPitch{73};
constexpr Field<vm::StringIndex> kNetName{74};
constexpr Field<vm::EntityIndex> kEnemy{75};
constexpr Field<float> kFlags{76}, kColorMap{77}, kTeam{78}, kMaxHealth{79}, kTeleportTime{80},
    kArmorType{81}, kArmorValue{82}, kWaterLevel{83}, kWaterType{84}, kIdealYaw{85}, kYawSpeed{86};
constexpr Field<vm::EntityIndex> kAimEntity{87}, kGoalEntity{88};
constexpr Field<float> kSpawnFlags{89};
constexpr Field<vm::StringIndex> kTarget{90}, kTargetName{91};
constexpr Field<float> kDamageTaken{92}, kDamageSaved{93};
constexpr Field<vm::EntityIndex> kDamageInflictor{94}, kOwner{95};
constexpr Field<math::Vec3> kMoveDirection{96};
constexpr Field<vm::StringIndex> kMessage{99};
constexpr Field<float> kSounds{100};
constexpr Field<vm::StringIndex> kNoise{101}, kNoise1{102}, kNoise2{103}, kNoise3{104};
}  // namespace field

constexpr std::uint32_t kSystemFieldWords = 105;

// The values of `movetype`, as physics (physics/physics.cpp) tells them apart.
enum class MoveType : int {
  kNone = 0,
  kWalk = 3,
  kStep = 4,
  kFly = 5,
  kToss = 6,
  kPush = 7,
  kNoClip = 8,
  kFlyMissile = 9,
  kBounce = 10,
  kFollow = 12,
};

// The values of `solid`: what an entity does to others that move into it.
enum class Solid : int { kNot = 0, kTrigger = 1, kBox = 2, kSlideBox = 3, kBsp = 4 };

// Bits of `flags`.
namespace flag {
constexpr int kFly = 1, kSwim = 2, kClient = 8, kInWater = 16, kMonster = 32, kGodMode = 64, kNoTarget = 128,
              kItem = 256, kOnGround = 512, kPartialGround = 1024, kWaterJump = 2048, kJumpReleased = 4096;
}  // namespace flag

// One entity: a view of its words in the machine. Cheap to copy; valid until the number of entities changes.
class Edict {
 public:
  Edict(vm::EntityIndex index, std::span<std::uint32_t> words) : index_(index), words_(words) {}

  vm::EntityIndex index() const { return index_; }
  std::span<std::uint32_t> words() const { return words_; }

  float operator[](Field<float> f) const { return std::bit_cast<float>(words_[f.word]); }
  math::Vec3 operator[](Field<math::Vec3> f) const {
    return {std::bit_cast<float>(words_[f.word]), std::bit_cast<float>(words_[f.word + 1]),
            std::bit_cast<float>(words_[f.word + 2])};
  }
  // Unchecked: QuakeC may have stored a number that is not an entity. Edicts::at() checks it.
  vm::EntityIndex operator[](Field<vm::EntityIndex> f) const { return vm::EntityIndex{words_[f.word]}; }
  vm::StringIndex operator[](Field<vm::StringIndex> f) const { return vm::StringIndex{words_[f.word]}; }
  vm::FunctionIndex operator[](Field<vm::FunctionIndex> f) const { return vm::FunctionIndex{words_[f.word]}; }

  void set(Field<float> f, float value) const { words_[f.word] = std::bit_cast<std::uint32_t>(value); }
  void set(Field<math::Vec3> f, const math::Vec3& value) const {
    for (int axis = 0; axis < 3; ++axis)
      words_[f.word + static_cast<std::uint32_t>(axis)] = std::bit_cast<std::uint32_t>(value[axis]);
  }
  template <base::IndexType Index>
  void set(Field<Index> f, Index value) const {
    words_[f.word] = static_cast<std::uint32_t>(value);
  }

  // A number that stands for something else, such as flags, truncated to an integer. Values out of range and
  // NaN count as 0.
  int whole(Field<float> f) const {
    const float value = (*this)[f];
    return value > -2e9f && value < 2e9f ? static_cast<int>(value) : 0;
  }
  MoveType move_type() const {
    constexpr int kGib = 11;  // of the 2021 release's programs
    const int number = whole(field::kMoveType);
    return number == kGib ? MoveType::kBounce : static_cast<MoveType>(number);
  }
  Solid solid() const { return static_cast<Solid>(whole(field::kSolid)); }
  int flags() const { return whole(field::kFlags); }
  bool has_flag(int flag) const { return (flags() & flag) != 0; }
  void set_flag(int flag) const { set(field::kFlags, static_cast<float>(flags() | flag)); }
  void clear_flag(int flag) const { set(field::kFlags, static_cast<float>(flags() & ~flag)); }

 private:
  vm::EntityIndex index_;
  std::span<std::uint32_t> words_;
};

}  // namespace temblor::server
