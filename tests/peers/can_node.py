"""A node that we did not write: canopen's LocalNode as the SDO server of CiA 301, on a virtual bus of python-can behind an SLCAN adapter
of a few lines on a TCP port. It tells sizes in its answers, refuses with codes of CiA 301, and wants sizes told.

    can_node.py     prints `ready on PORT`
"""

import socket
import threading

import can
import canopen

NODE = 5
STATUS_WORD, FIXED_FREQUENCY, OFFSET = 411, 480, 382
FIRST = {STATUS_WORD: 0x33, FIXED_FREQUENCY: 500, OFFSET: -125}
TYPES = {
    STATUS_WORD: canopen.objectdictionary.datatypes.UNSIGNED16,
    FIXED_FREQUENCY: canopen.objectdictionary.datatypes.INTEGER32,
    OFFSET: canopen.objectdictionary.datatypes.INTEGER16,
}


def dictionary():
    """Index = parameter, sub-index = data set."""
    found = canopen.ObjectDictionary()
    found.node_id = NODE
    for index, kind in TYPES.items():
        record = canopen.objectdictionary.ODRecord(f"P{index}", index)
        for data_set in range(5):
            variable = canopen.objectdictionary.ODVariable(f"set {data_set}", index, data_set)
            variable.data_type, variable.default, variable.access_type = kind, FIRST[index], "rw"
            record.add_member(variable)
        found.add_object(record)
    return found


def frame(word):
    """A frame of 11 bits with data."""
    return can.Message(arbitration_id=int(word[1:4], 16), data=bytes.fromhex(word[5:]), is_extended_id=False)


def serve(connection, bus):
    """One host, until it goes."""
    listener = can.Notifier(bus, [lambda came: connection.sendall(text(came))])
    word = ""
    while piece := connection.recv(512):
        for letter in piece.decode("ascii"):
            if letter != "\r":
                word += letter
                continue
            if word.startswith("t"):
                bus.send(frame(word))
            connection.sendall({"V": b"V1013\r", "F": b"F00\r", "t": b"z\r"}.get(word[:1], b"\r"))
            word = ""
    listener.stop()


def text(came):
    return f"t{came.arbitration_id:03X}{came.dlc}{bytes(came.data).hex().upper()}\r".encode()


def main():
    network = canopen.Network(can.Bus(interface="virtual", channel="peers"))
    network.connect()
    network.add_node(canopen.LocalNode(NODE, dictionary()))
    bus = can.Bus(interface="virtual", channel="peers")
    with socket.create_server(("127.0.0.1", 0)) as server:
        print(f"ready on {server.getsockname()[1]}", flush=True)
        while True:
            connection, _ = server.accept()
            threading.Thread(target=serve, args=(connection, bus), daemon=True).start()


if __name__ == "__main__":
    main()
