// Builds demos message by message, in protocol 15.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string_view>

#include "formats/game/dem.h"
#include "net/protocol/message_writer.h"

namespace temblor::test {

class DemoBuilder {
 public:
  void record(std::initializer_list<net::ServerMessage> messages,
              const math::Vec3& view_angles_deg = math::Vec3(0.0f)) {
    base::ByteWriter writer;
    write(messages, writer);
    demo_.add(view_angles_deg, writer.view());
  }
  void packet(float time_s, std::initializer_list<net::ServerMessage> messages,
              const math::Vec3& view_angles_deg = math::Vec3(0.0f)) {
    base::ByteWriter writer;
    write({net::Time{time_s}}, writer);
    write(messages, writer);
    demo_.add(view_angles_deg, writer.view());
  }
  void packet(float time_s, std::string_view bytes) {
    base::ByteWriter writer;
    write({net::Time{time_s}}, writer);
    writer.bytes(base::as_bytes(bytes));
    demo_.add({}, writer.view());
  }
  // The next packet with an entity starts the game.
  void signon(const net::ServerInfo& info) {
    record({info, net::SetView{1}, net::SignonNumber{1}});
    record({net::SignonNumber{2}});
    record({net::SignonNumber{3}});
  }
  base::ByteVector bytes() const { return formats::DemWriter(demo_).take(); }

 private:
  static void write(std::initializer_list<net::ServerMessage> messages, base::ByteWriter& io_writer) {
    for (const net::ServerMessage& message : messages)
      EXPECT_TRUE(net::write_message(message, {}, io_writer).ok()) << net::message_name(message);
  }
  formats::DemWriter demo_;
};

}  // namespace temblor::test
