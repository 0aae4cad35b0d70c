from ledger import Ledger
def run(ground, end, random):
    return Ledger("left_running")
